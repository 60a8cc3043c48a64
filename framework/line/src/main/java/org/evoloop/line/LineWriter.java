package org.evoloop.line;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.function.Consumer;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.line.LineTransport.Wire;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;

/**
 * Writes lines, and hangs up if the other end accepts none.
 *
 * <p>Threading: thread-safe; the bytes of a line stay together.
 */
final class LineWriter {
    private static final Duration LIMIT = Duration.ofSeconds(5);

    private final Clock clock;
    private final String place;
    private final Consumer<String> hangUp;

    /**
     * Writes to any wire.
     *
     * @param place the wire's destination, for messages
     * @param hangUp closes the wire, which may block; receives the reason
     */
    LineWriter(Clock clock, String place, Consumer<String> hangUp) {
        this.clock = clock;
        this.place = place;
        this.hangUp = hangUp;
    }

    /** @throws UnknownEffectException if the line may not have arrived */
    void write(Wire wire, String line) throws UnknownEffectException {
        Runnable stuck = () -> hangUp.accept(place + " took nothing for " + LIMIT.toSeconds() + " s; is it stuck?");
        Clock.Timer late = clock.schedule(LIMIT, () -> Threads.start("line-late", stuck));
        try {
            synchronized (wire) {
                wire.output().write((line + "\n").getBytes(StandardCharsets.UTF_8));
                wire.output().flush();
            }
        } catch (IOException failure) {
            throw new UnknownEffectException(
                    place + " is lost; whether '" + line + "' has arrived is not known", failure);
        } finally {
            late.cancel();
        }
    }
}
