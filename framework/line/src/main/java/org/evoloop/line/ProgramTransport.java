package org.evoloop.line;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** A program of this machine, by its standard input and output. */
record ProgramTransport(List<String> command) implements LineTransport {
    private static final int EXIT_SECONDS = 1;

    ProgramTransport {
        command = Programs.requireCommand(command);
    }

    /** @param atExit ends the program if this one ends without closing the wire */
    private record ProgramWire(Process process, InputStream input, OutputStream output, Thread atExit) implements Wire {
        static ProgramWire of(Process process, String name) {
            InputStream input = new FilterInputStream(process.getInputStream()) {
                @Override
                public int read(byte[] bytes, int start, int length) throws IOException {
                    int read = super.read(bytes, start, length);
                    if (read < 0) {
                        throw new IOException(name + " has ended" + status(process));
                    }
                    return read;
                }
            };
            Thread atExit = new Thread(() -> Programs.kill(process), "program-exit");
            Runtime.getRuntime().addShutdownHook(atExit);
            return new ProgramWire(process, input, process.getOutputStream(), atExit);
        }

        private static String status(Process process) {
            try {
                return process.waitFor(EXIT_SECONDS, TimeUnit.SECONDS)
                        ? " with status " + process.exitValue()
                        : ", or closed its output";
            } catch (InterruptedException closing) {
                Thread.currentThread().interrupt();
                return "";
            }
        }

        @Override
        public void close() {
            Programs.end(process);
            try {
                Runtime.getRuntime().removeShutdownHook(atExit);
            } catch (IllegalStateException exiting) {
                // It is run just now.
            }
        }
    }

    @Override
    public Wire open() throws IOException {
        return ProgramWire.of(Programs.start(new ProcessBuilder(command), toString()), toString());
    }

    @Override
    public String toString() {
        return Programs.name(command);
    }
}
