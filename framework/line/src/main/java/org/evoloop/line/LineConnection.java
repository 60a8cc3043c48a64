package org.evoloop.line;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.function.Reading;
import org.evoloop.payload.Part;
import org.evoloop.payload.Readings;
import org.evoloop.payload.RemoteFunction;
import org.evoloop.time.Clock;

/**
 * A connection to a device or service that exchanges lines of text (UTF-8). It reconnects whenever it is lost, with
 * pauses of 250 ms to 30 s. A fault is logged once, until it changes or ends.
 *
 * <p>Received lines end with CR, LF or both; sent lines, with LF. Input that is not UTF-8, is longer than 4096 bytes,
 * or is cut off by a loss is ignored.
 *
 * <p>Lifecycle: {@link #greet}, {@link #watch}, {@link #reading} and the components that listen, then {@link #open},
 * which does not wait; {@link #close}.
 *
 * <p>Threading: all methods may be called from any thread.
 *
 * @since 0.1
 */
public final class LineConnection implements DeviceLink, AutoCloseable {
    private final Clock clock;
    private final Reconnector wire;
    private final Exchanges exchanges;
    private final Readings readings = new Readings();

    /** @param clock measures pauses and limits */
    public LineConnection(LineTransport transport, Clock clock) {
        this.clock = clock;
        this.wire = new Reconnector(transport, clock);
        this.exchanges = new Exchanges(wire, clock);
        wire.add(new WireUser() {
            @Override
            public void heard(String line) {
                readings.hear("", line);
            }

            @Override
            public void lost(String why) {
                readings.clear();
            }
        });
        wire.add(exchanges);
    }

    /** Sends these lines after each connect, for example to ask for the device's state or to log in. */
    public LineConnection greet(String... lines) {
        for (String line : lines) {
            requireOneLine(line);
        }
        wire.add(new WireUser() {
            @Override
            public void connected() throws IOException {
                for (String line : lines) {
                    wire.write(line);
                }
            }
        });
        return this;
    }

    /**
     * Detects that the other end hangs: after silence for {@code limit}, {@code question} is sent, and after silence
     * for as long again, it reconnects.
     */
    public LineConnection watch(Duration limit, String question) {
        // First, so that a listener that blocks on a line does not make the connection look silent.
        wire.addFirst(new Silence(clock, limit, requireOneLine(question), wire));
        return this;
    }

    /**
     * Adds a reading to the status, from what the device reports.
     *
     * @param name as of a {@link Reading}, such as {@code battery}
     * @param line with one group, the value, as in {@code "battery ([0-9]+)"}
     * @param unit of a number, such as {@code %}; else empty
     * @throws IllegalArgumentException if {@code line} has no group
     */
    public LineConnection reading(String name, Pattern line, String unit) {
        return reading(name, Part.WHOLE.group(line), unit);
    }

    /** As {@link #reading(String, Pattern, String)}, of lines that are JSON. */
    public LineConnection reading(String name, Part part, String unit) {
        readings.add("", name, part, unit);
        return this;
    }

    /**
     * The program at the other end as one that runs functions: {@code new RemoteFunction(connection.functions())}, before
     * {@link #open}.
     */
    public RemoteFunction.Channel functions() {
        return new LineFunctions(this, wire);
    }

    /** Measures limits and pauses. */
    Clock clock() {
        return clock;
    }

    /** Adds a listener for all lines that are not answers. It must be quick. */
    void listen(Consumer<String> listener) {
        exchanges.listen(listener);
    }

    /** Starts connecting; does nothing if it was opened before. */
    public void open() {
        wire.open();
    }

    /**
     * Sends a line.
     *
     * @throws UnknownEffectException if it may not have arrived
     * @throws IOException if it was not sent
     */
    public void send(String line) throws IOException {
        wire.write(requireOneLine(line));
    }

    /**
     * Sends a line and waits for its answer. If none comes in time, it reconnects, since a late answer would be taken
     * for that of the next line.
     *
     * @param answers the pattern of an answer; answers are not passed to monitors
     * @param heard receives the answer on the thread that reads, in its order among the lines passed to monitors
     * @return the answer
     * @throws UnknownEffectException if there is none, or the line may not have arrived
     * @throws IOException if the line was not sent
     */
    public String ask(String line, Pattern answers, Duration limit, Consumer<String> heard)
            throws IOException, InterruptedException {
        return exchanges.ask(requireOneLine(line), answers, limit, heard);
    }

    static String requireOneLine(String line) {
        if (line.isEmpty() || line.indexOf('\n') >= 0 || line.indexOf('\r') >= 0) {
            throw new IllegalArgumentException("'" + line + "' is not one line");
        }
        return line;
    }

    @Override
    public boolean isUp() {
        return wire.isUp();
    }

    @Override
    public Optional<Instant> downSince() {
        return Optional.ofNullable(wire.health().downSince());
    }

    @Override
    public List<Reading> readings() {
        return readings.known();
    }

    @Override
    public String describe() {
        String wrong = wire.health().trouble();
        return wrong.isEmpty() ? wire.place() : wrong;
    }

    /** Disconnects and ends. Idempotent. */
    @Override
    public void close() {
        wire.close();
    }
}
