package org.evoloop.mqtt.edge;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.HashMap;
import java.util.Map;

/**
 * The number of the last command of each device, in a file that is written before the device gets the command: after a
 * crash, no command is repeated.
 *
 * <p>Errors: if the file cannot be used, {@link UncheckedIOException}.
 *
 * <p>Threading: for one thread.
 *
 * @since 0.1
 */
public final class LastCommands implements AutoCloseable {
    private static final int MOST_LINES = 100_000;

    private final Path file;
    private final Map<String, Long> last = new HashMap<>();
    private FileChannel lines;
    private int written;

    /** @param directory contains the file; must exist */
    public LastCommands(Path directory) {
        file = directory.resolve("carried");
        try {
            if (Files.exists(file)) {
                for (String line : Files.readAllLines(file)) {
                    int between = line.indexOf(' ');
                    // The last line may lack its end; its command did not reach the device.
                    if (between > 0 && line.endsWith(";")) {
                        last.put(
                                line.substring(between + 1, line.length() - 1),
                                Long.parseLong(line.substring(0, between)));
                    }
                }
            }
            lines = rewritten();
        } catch (IOException e) {
            throw new UncheckedIOException(file + " cannot be used: " + e.getMessage(), e);
        }
    }

    private FileChannel rewritten() throws IOException {
        StringBuilder all = new StringBuilder();
        last.forEach((device, sequence) -> all.append(line(device, sequence)));
        Path next = file.resolveSibling("carried.new");
        Files.writeString(next, all);
        Files.move(next, file, StandardCopyOption.ATOMIC_MOVE);
        return FileChannel.open(file, StandardOpenOption.WRITE, StandardOpenOption.APPEND);
    }

    private static String line(String device, long sequence) {
        return sequence + " " + device + ";\n";
    }

    /** Returns whether this command is to be carried out, and counts it as carried out from now on. */
    public boolean take(String device, long sequence) {
        if (last.getOrDefault(device, 0L) >= sequence) {
            return false;
        }
        try {
            append(line(device, sequence));
            last.put(device, sequence);
            if (++written > MOST_LINES) {
                lines.close();
                lines = rewritten();
                written = 0;
            }
        } catch (IOException e) {
            throw new UncheckedIOException(file + " cannot be written: " + e.getMessage(), e);
        }
        return true;
    }

    private void append(String line) throws IOException {
        long before = lines.size();
        try {
            lines.write(ByteBuffer.wrap(line.getBytes(StandardCharsets.UTF_8)));
            lines.force(false);
        } catch (IOException e) {
            // A part of the line, as on a full disk, would spoil the next one.
            lines.truncate(before);
            throw e;
        }
    }

    /** The last command that counts as executed; 0 if there is none. */
    public long last(String device) {
        return last.getOrDefault(device, 0L);
    }

    @Override
    public void close() {
        try {
            lines.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
