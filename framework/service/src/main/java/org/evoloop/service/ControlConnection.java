package org.evoloop.service;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One client of the control socket. It has {@link #LIMIT} to send each request, and as long to read the answer.
 *
 * <p>Threading: the server's thread; a command runs on its own thread and passes its answer back.
 */
final class ControlConnection {
    /** The longest request in bytes, including its line feed. */
    static final int LONGEST_LINE = 4096;

    static final String TOO_LONG = "the command is longer than " + (LONGEST_LINE - 1) + " bytes";

    static final Duration LIMIT = Duration.ofSeconds(30);

    private static final Logger LOG = LoggerFactory.getLogger(ControlConnection.class);
    private static final ByteBuffer NOTHING = ByteBuffer.allocate(0);

    private final ControlServer server;
    private final SocketChannel channel;
    private final SelectionKey key;
    private final ByteBuffer in = ByteBuffer.allocate(LONGEST_LINE);
    private ByteBuffer out = NOTHING;
    private boolean busy;
    private boolean endOfRequests;
    private boolean refused;
    private Clock.@Nullable Timer deadline;

    ControlConnection(ControlServer server, SocketChannel channel, Selector selector) throws IOException {
        this.server = server;
        this.channel = channel;
        this.key = channel.register(selector, 0, this);
        renewDeadline();
    }

    /** Whether no command of this client is in progress. */
    boolean isIdle() {
        return !busy;
    }

    /** Does what can be done without waiting. */
    void advance() {
        try {
            boolean progress = true;
            while (progress && !busy && key.isValid()) {
                progress = out.hasRemaining() ? channel.write(out) > 0 : takeRequest() || read();
            }
            if (key.isValid()) {
                key.interestOps(busy ? 0 : out.hasRemaining() ? SelectionKey.OP_WRITE : SelectionKey.OP_READ);
            }
        } catch (IOException brokenOff) {
            drop();
        }
    }

    private boolean read() throws IOException {
        if (refused) {
            discard();
            return false;
        }
        if (endOfRequests) {
            // A client that has asked for the end learns of it when the connection closes.
            if (server.commands().isEnding()) {
                key.interestOps(0);
                busy = true;
            } else {
                drop();
            }
            return false;
        }
        int count = channel.read(in);
        if (count < 0) {
            endOfRequests = true;
            if (in.position() > 0) {
                refuse("the command has no line feed at its end");
            }
        }
        return count != 0;
    }

    /** Performs the next command, if it has arrived completely. */
    private boolean takeRequest() {
        for (int index = 0; index < in.position(); index++) {
            if (in.get(index) == '\n') {
                String line = new String(in.array(), 0, index, StandardCharsets.UTF_8);
                in.flip().position(index + 1);
                in.compact();
                perform(line);
                return true;
            }
        }
        if (!in.hasRemaining()) {
            refuse(TOO_LONG);
            return true;
        }
        return false;
    }

    private void refuse(String why) {
        refused = true;
        in.clear();
        out = ByteBuffer.wrap(Reply.refusal(why));
    }

    /** A connection that is closed before everything was read would take the answer from a client that is still sending. */
    private void discard() throws IOException {
        channel.shutdownOutput();
        int count = channel.read(in);
        in.clear();
        if (count < 0) {
            drop();
        }
    }

    private void perform(String line) {
        busy = true;
        cancelDeadline();
        server.work(() -> {
            byte[] reply = replyTo(line);
            server.later(() -> answer(reply));
        });
    }

    private byte[] replyTo(String line) {
        ByteArrayOutputStream results = new ByteArrayOutputStream();
        ByteArrayOutputStream errors = new ByteArrayOutputStream();
        int status;
        try {
            status = server.commands().perform(line, utf8(results), utf8(errors));
        } catch (InterruptedException ending) {
            return Reply.of("", "error: the program ends", 1);
        } catch (Throwable failure) {
            LOG.warn("the command '{}' failed", line, failure);
            return Reply.of("", "error: " + failure, 1);
        }
        return Reply.of(results.toString(StandardCharsets.UTF_8), errors.toString(StandardCharsets.UTF_8), status);
    }

    private static PrintStream utf8(ByteArrayOutputStream bytes) {
        return new PrintStream(bytes, true, StandardCharsets.UTF_8);
    }

    private void answer(byte[] reply) {
        busy = false;
        out = ByteBuffer.wrap(reply);
        server.served(this);
        renewDeadline();
        advance();
    }

    private void renewDeadline() {
        cancelDeadline();
        deadline = server.clock().schedule(LIMIT, () -> server.later(this::drop));
    }

    private void cancelDeadline() {
        Clock.Timer pending = deadline;
        if (pending != null) {
            pending.cancel();
        }
    }

    /** Ends the connection. Idempotent. */
    void drop() {
        cancelDeadline();
        server.gone(this);
        try {
            channel.close();
        } catch (IOException failure) {
            LOG.debug("a connection cannot be closed", failure);
        }
    }
}
