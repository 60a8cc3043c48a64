package org.evoloop.service;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.evoloop.time.Threads;

/**
 * A running instance, as seen by a client of its control socket.
 *
 * <p>A command may take long, but a process that is stopped never answers. While there is no answer, the instance is
 * therefore given an empty command on another connection, which it answers at once if it is alive.
 *
 * <p>Threading: each connection is used on a daemon thread of its own, since a Unix domain socket has no time limits.
 */
final class Instance {
    /** How long an answer is waited for, before and after the instance is asked whether it is alive. */
    static final Duration PATIENCE = Duration.ofSeconds(5);

    private final Path socket;
    private final Duration patience;

    Instance(Path socket, Duration patience) {
        this.socket = socket;
        this.patience = patience;
    }

    /** Whether a process has the socket open. */
    boolean isThere() {
        FutureTask<Void> connecting = begin(() -> {
            connect().close();
            return null;
        });
        try {
            await(connecting);
            return true;
        } catch (TimeoutException silent) {
            // Clients are waiting for a process that is stopped.
            return true;
        } catch (IOException leftByOneThatDied) {
            return false;
        }
    }

    /**
     * Gives the instance a command.
     *
     * @return the exit status
     * @throws IOException if it does not answer
     */
    int perform(String line, PrintStream results, PrintStream errors) throws IOException {
        FutureTask<Integer> answer = begin(() -> converse(line, results, errors));
        while (true) {
            try {
                return await(answer);
            } catch (TimeoutException slow) {
                if (isSilent()) {
                    answer.cancel(true);
                    throw new IOException("its process is stopped or hangs");
                }
            }
        }
    }

    private boolean isSilent() {
        PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream());
        FutureTask<Integer> sign = begin(() -> converse("", nowhere, nowhere));
        try {
            await(sign);
            return false;
        } catch (TimeoutException silent) {
            sign.cancel(true);
            return true;
        } catch (IOException ending) {
            return false;
        }
    }

    private static <T> FutureTask<T> begin(Callable<T> work) {
        FutureTask<T> task = new FutureTask<>(work);
        Threads.start("evoloop-ctl", task);
        return task;
    }

    private <T> T await(FutureTask<T> task) throws IOException, TimeoutException {
        try {
            return task.get(patience.toNanos(), TimeUnit.NANOSECONDS);
        } catch (ExecutionException failed) {
            throw new IOException(
                    Objects.requireNonNullElse(failed.getCause(), failed).getMessage(), failed);
        } catch (InterruptedException end) {
            task.cancel(true);
            Thread.currentThread().interrupt();
            throw new InterruptedIOException("the wait for its answer was interrupted");
        }
    }

    private SocketChannel connect() throws IOException {
        SocketChannel channel = SocketChannel.open(StandardProtocolFamily.UNIX);
        try {
            channel.connect(UnixDomainSocketAddress.of(socket));
            return channel;
        } catch (IOException failure) {
            channel.close();
            throw failure;
        }
    }

    private int converse(String line, PrintStream results, PrintStream errors) throws IOException {
        try (SocketChannel channel = connect()) {
            ByteBuffer request = StandardCharsets.UTF_8.encode(line + "\n");
            while (request.hasRemaining()) {
                channel.write(request);
            }
            // Announces that no request follows: the instance then closes the connection after its answer, or when it
            // has ended.
            channel.shutdownOutput();
            return show(new BufferedReader(Channels.newReader(channel, StandardCharsets.UTF_8)), results, errors);
        }
    }

    private static int show(BufferedReader answer, PrintStream results, PrintStream errors) throws IOException {
        int status = -1;
        for (String line = answer.readLine(); line != null; line = answer.readLine()) {
            if (line.startsWith(Reply.OUT)) {
                results.println(line.substring(Reply.OUT.length()));
            } else if (line.startsWith(Reply.ERR)) {
                errors.println(line.substring(Reply.ERR.length()));
            } else if (line.startsWith(Reply.END)) {
                status = Integer.parseInt(line.substring(Reply.END.length()));
            }
        }
        if (status < 0) {
            throw new IOException("it has closed the connection");
        }
        return status;
    }
}
