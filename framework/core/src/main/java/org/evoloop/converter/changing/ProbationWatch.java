package org.evoloop.converter.changing;

import java.util.function.Consumer;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.EvolutionException;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.Probation;
import org.evoloop.converter.running.ConverterShell;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;

/**
 * Watches a converter on probation, and rolls back at the first fault.
 *
 * <p>Threading: thread-safe; it never rolls back on the listeners' thread, which must not wait.
 */
final class ProbationWatch implements ConverterListener {
    private final LoopConfig config;
    private final ConverterShell shell;
    private final Probation probation;
    private final Probation.Watch watch;
    private final Consumer<String> announce;
    private final Runnable rollBack;

    /** The number of the last event before the trial. */
    private final long first;

    private final long begunNanos;
    private Clock.@Nullable Timer end;
    private long events;
    private volatile boolean over;

    // In a converter without threads: why it has to roll back, null if it need not, and since when.
    private @Nullable String fault;
    private long faultNanos;
    private boolean announced;

    /**
     * A trial of the models that have just taken over.
     *
     * @param announce is told why they are rolled back, before the first attempt
     * @param rollBack rolls them back
     */
    ProbationWatch(
            LoopConfig config,
            ConverterShell shell,
            Probation probation,
            Consumer<String> announce,
            Runnable rollBack) {
        this.config = config;
        this.shell = shell;
        this.probation = probation;
        this.watch = probation
                .watches()
                .begin(shell.driver().rules().table(), shell.driver().configuration());
        this.announce = announce;
        this.rollBack = rollBack;
        this.first = shell.driver().recorded();
        this.begunNanos = config.clock().nanoTime();
    }

    /** Begins to watch. */
    synchronized void begin() {
        shell.records().listeners().add(this);
        if (!probation.time().isZero()) {
            end = config.clock().schedule(probation.time(), this::end);
        }
    }

    /** Ends the trial; the models stay. Idempotent. */
    synchronized void end() {
        if (!over) {
            over = true;
            shell.records().listeners().remove(this);
            if (end != null) {
                end.cancel();
            }
        }
    }

    boolean isOver() {
        return over;
    }

    /** For messages: {@code for 40 s}. */
    synchronized String describe() {
        long passed = config.clock().nanoTime() - begunNanos;
        String time = probation.time().isZero()
                ? ""
                : Math.max(0, probation.time().minusNanos(passed).toSeconds()) + " s";
        String number = probation.events() == 0 ? "" : probation.events() - events + " events";
        return "for " + time + (time.isEmpty() || number.isEmpty() ? "" : " or ") + number;
    }

    @Override
    public void ended(HistoryEntry entry) {
        if (over || entry.number() <= first) {
            return;
        }
        String why = fault(entry);
        if (!why.isEmpty()) {
            fail(why);
            return;
        }
        synchronized (this) {
            events++;
        }
        if (probation.events() > 0 && events >= probation.events()) {
            end();
        }
    }

    private String fault(HistoryEntry entry) {
        if (entry.occurrence() instanceof Occurrence.Violated violated) {
            return "'" + violated.property() + "' is violated";
        }
        if (entry.occurrence() instanceof Occurrence.InDoubt doubt && doubt.observedNanos() - begunNanos >= 0) {
            // It may have been settled before this was told of it.
            return inDoubt(doubt.why());
        }
        if (entry.outcome() == Outcome.FAILED) {
            return entry.occurrence().label() + " failed: " + entry.detail();
        }
        return entry.decision() instanceof Decision.Resynchronization found && isNews(found)
                ? "the device was " + entry.occurrence().label() + " when it was taken to be in "
                        + entry.before().original()
                : watch.faultIn(entry);
    }

    /** Whether the record was wrong, and not only the new model elsewhere. */
    private static boolean isNews(Decision.Resynchronization found) {
        return !found.before().original().equals(found.after().original());
    }

    @Override
    public void doubted(String why) {
        // A doubt reported late may have been settled before the trial began.
        if (!why.isEmpty() && !over && !shell.driver().doubt().isEmpty()) {
            fail(inDoubt(why));
        }
    }

    private static String inDoubt(String why) {
        return "the record is in doubt: " + why;
    }

    private void fail(String why) {
        end();
        if (config.threads()) {
            Threads.start("converter-" + config.name() + "-rollback", () -> rollBack(why));
        } else {
            fault = why;
            faultNanos = config.clock().nanoTime();
        }
    }

    /**
     * In a converter without threads, the caller that steps it rolls back: as soon as that is possible, since the device
     * may have to be asked first.
     */
    void stepped() {
        String why = fault;
        if (why == null) {
            return;
        }
        fault = null;
        long waited = config.clock().nanoTime() - faultNanos;
        if (!rollBack(why) && waited < Evolution.USUAL_DEADLINE.toNanos()) {
            fault = why;
        }
    }

    /** Returns whether nothing is left to be done. */
    private boolean rollBack(String why) {
        try {
            if (!announced) {
                announced = true;
                announce.accept(why);
            }
            rollBack.run();
            return true;
        } catch (EvolutionException | IllegalStateException impossible) {
            shell.records().failures().warn(why + "; " + impossible.getMessage());
            return impossible instanceof IllegalStateException;
        }
    }
}
