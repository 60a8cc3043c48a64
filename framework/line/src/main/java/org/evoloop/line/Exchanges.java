package org.evoloop.line;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Separates answers from all other lines.
 *
 * <p>Threading: thread-safe; questions are asked one at a time, in the order of the calls.
 */
final class Exchanges implements WireUser {
    private final Reconnector wire;
    private final Clock clock;
    private final List<Consumer<String>> listeners = new CopyOnWriteArrayList<>();
    private final ReentrantLock turn = new ReentrantLock(true);
    private volatile @Nullable Exchange current;

    private record Exchange(Pattern answers, Consumer<String> heard, CompletableFuture<String> answer) {
        boolean takes(String line) {
            if (answer.isDone() || !answers.matcher(line).matches()) {
                return false;
            }
            heard.accept(line);
            return answer.complete(line);
        }

        void fail(String why) {
            answer.completeExceptionally(new IOException(why));
        }
    }

    Exchanges(Reconnector wire, Clock clock) {
        this.wire = wire;
        this.clock = clock;
    }

    /** Adds a listener for all lines that are not answers. */
    void listen(Consumer<String> listener) {
        listeners.add(listener);
    }

    @Override
    public void heard(String line) {
        Exchange asked = current;
        if (asked == null || !asked.takes(line)) {
            listeners.forEach(listener -> listener.accept(line));
        }
    }

    @Override
    public void lost(String why) {
        Exchange asked = current;
        if (asked != null) {
            asked.fail(why);
        }
    }

    /** See {@link LineConnection#ask}. */
    String ask(String line, Pattern answers, Duration limit, Consumer<String> heard)
            throws IOException, InterruptedException {
        turn.lockInterruptibly();
        Exchange asked = new Exchange(answers, heard, new CompletableFuture<>());
        String late = wire.place() + " has not answered '" + line + "' within " + limit.toMillis() + " ms";
        boolean sent = false;
        current = asked;
        try {
            wire.write(line);
            sent = true;
            return await(asked, limit, late);
        } finally {
            current = null;
            if (sent && (!asked.answer().isDone() || asked.answer().isCompletedExceptionally())) {
                wire.hangUp(late);
            }
            turn.unlock();
        }
    }

    private String await(Exchange asked, Duration limit, String late) throws IOException, InterruptedException {
        Clock.Timer timer = clock.schedule(limit, () -> asked.fail(late));
        try {
            return asked.answer().get();
        } catch (ExecutionException none) {
            Throwable cause = none.getCause();
            throw new UnknownEffectException(cause == null ? late : String.valueOf(cause.getMessage()), none);
        } finally {
            timer.cancel();
        }
    }
}
