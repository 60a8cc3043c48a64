package org.evoloop.converter.changing;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.evoloop.converter.EventMonitor;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.EvolutionException;
import org.evoloop.converter.Shadow;
import org.evoloop.converter.ShadowReport;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.converter.attachment.KnowledgeAccess;
import org.evoloop.converter.running.Assembly;
import org.evoloop.converter.running.ConverterShell;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Swap;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.EventNames;
import org.evoloop.loop.LoopConfig;
import org.evoloop.migration.Fate;
import org.evoloop.migration.Mapping;
import org.evoloop.migration.Migration;
import org.evoloop.statemachine.ModelException;
import org.jspecify.annotations.Nullable;

/**
 * Replaces the models of a running converter. Everything is checked and compiled beforehand; then the takeover is tried
 * between two events, again after each event, until it succeeds or the deadline passes.
 *
 * <p>Threading: thread-safe; the converter may be changed by others while it waits.
 */
final class Evolver {
    /**
     * The polling interval: there is no signal for the start of a stopped converter, or for another clock's progress.
     */
    private static final long LOOK_MILLIS = 20;

    private final LoopConfig config;
    private final ChangeLock changes;
    private final Ownership ownership;
    private final Supplier<Assembly> assembly;

    /** Guarded by {@code changes}, like everything that changes here. */
    private volatile @Nullable WayBack wayBack;

    private volatile @Nullable LiveShadow shadow;

    /** The way back from an evolution of the previous process, as the models with which the converter was built. */
    private volatile @Nullable WayBack resumed;

    /**
     * The way back to the previous models.
     *
     * @param trial the trial after which it will not be needed; null if there is none
     */
    private record WayBack(
            StateKnowledge from,
            StateKnowledge to,
            Mapping mapping,
            @Nullable ProbationWatch trial) {
        /** For messages. */
        String tookOver() {
            return "'" + from.models().evolved().name() + "', which took over from '"
                    + to.models().evolved().name() + "'";
        }
    }

    /** The checked and compiled takeover; valid as long as the converter has this knowledge and these components. */
    private record Prepared(StateKnowledge present, Assembly components, Swap swap) {}

    Evolver(LoopConfig config, ChangeLock changes, Ownership ownership, Supplier<Assembly> assembly) {
        this.config = config;
        this.changes = changes;
        this.ownership = ownership;
        this.assembly = assembly;
    }

    /** As {@link SystemEventConverter#evolve}. */
    Evolution.Result evolve(ConverterShell shell, Evolution evolution) {
        StateKnowledge next = evolution.next();
        changes.change(() -> ownership.take(next, next.name()));
        try {
            return evolve(shell, evolution, false);
        } catch (RuntimeException refused) {
            ownership.giveBack(next);
            throw refused;
        }
    }

    /** As {@link SystemEventConverter#rollBack}. */
    Evolution.Result rollBack(ConverterShell shell, Duration deadline, String why) {
        requireNonNull(deadline, "the deadline is null");
        wayBack(shell);
        announce(shell, why);
        return rollBack(shell, deadline);
    }

    private static void announce(ConverterShell shell, String why) {
        shell.records().transcript().notice("***  The converter rolls back, " + why + ".  ***  ");
    }

    private Evolution.Result rollBack(ConverterShell shell, Duration deadline) {
        WayBack back = wayBack(shell);
        Evolution evolution = Evolution.to(back.to())
                .withMapping(back.mapping())
                .withDeadline(deadline)
                .withoutWayBack();
        return evolve(shell, evolution, true);
    }

    private WayBack wayBack(ConverterShell shell) {
        WayBack back = wayBack == null ? resumed : wayBack;
        if (back == null || back.from() != shell.knowledge()) {
            throw new IllegalStateException("there is nothing to roll back to: the converter " + config.name()
                    + " has not evolved, or said that it need not be undone");
        }
        return back;
    }

    /** As {@link SystemEventConverter#shadow(Evolution)}. */
    Shadow shadow(ConverterShell shell, Evolution evolution) {
        LiveShadow begun = new LiveShadow(shell, evolution);
        StateKnowledge next = evolution.next();
        changes.change(() -> {
            ownership.take(next, next.name());
            try {
                shell.shadow(
                        compile(shell, evolution, false).swap(),
                        evolution.probation().watches());
            } catch (RuntimeException refused) {
                ownership.giveBack(next);
                throw refused;
            }
            forgetShadow(null);
            shadow = begun;
        });
        return begun;
    }

    /** The present shadow; null if there is none. */
    @Nullable
    Shadow shadow() {
        return shadow;
    }

    /** As {@link Shadow#promote}. */
    private Evolution.Result promote(LiveShadow promoted, ConverterShell shell) {
        if (shadow != promoted) {
            throw new IllegalStateException("the shadow has ended");
        }
        return evolve(shell, promoted.evolution(), false);
    }

    /** As {@link Shadow#close}. */
    private void end(LiveShadow ended, ConverterShell shell) {
        changes.change(() -> {
            if (shadow == ended) {
                shell.driver().endShadow();
                forgetShadow(null);
            }
        });
    }

    /** @param adopted the knowledge that has taken over; null if none has */
    private void forgetShadow(@Nullable StateKnowledge adopted) {
        LiveShadow ended = shadow;
        shadow = null;
        if (ended != null && ended.evolution().next() != adopted) {
            ownership.giveBack(ended.evolution().next());
        }
    }

    /** @param back whether this is a rollback, which has no way back itself */
    private Evolution.Result evolve(ConverterShell shell, Evolution evolution, boolean back) {
        long begun = config.clock().nanoTime();
        Attempt attempt = new Attempt(shell, evolution, back);
        boolean told = false;
        while (true) {
            changes.change(attempt);
            if (attempt.result != null) {
                return attempt.result;
            }
            boolean late =
                    config.clock().nanoTime() - begun >= evolution.deadline().toNanos();
            if (attempt.stuck || late || !config.threads()) {
                throw new EvolutionException("the converter " + config.name() + " has not evolved to '"
                        + evolution.next().models().evolved().name() + "'"
                        + (late && !attempt.stuck
                                ? " within " + evolution.deadline().toSeconds() + " s"
                                : "") + ": "
                        + attempt.hindrance
                        + (attempt.stuck ? "; no event leads to where it is possible" : ""));
            }
            if (!told) {
                told = true;
                evolution
                        .waits()
                        .accept(attempt.hindrance + "; waiting for up to "
                                + evolution.deadline().toSeconds() + " s");
            }
            try {
                shell.driver().awaitEnded(LOOK_MILLIS);
            } catch (InterruptedException interrupted) {
                Thread.currentThread().interrupt();
                throw new EvolutionException("the converter " + config.name() + " has not evolved: "
                        + Thread.currentThread().getName() + " was interrupted");
            }
        }
    }

    /** Checks everything, and compiles the next models' decisions. */
    private Prepared compile(ConverterShell shell, Evolution evolution, boolean back) {
        StateKnowledge next = evolution.next();
        StateKnowledge present = shell.knowledge();
        Assembly components = assembly.get();
        KnowledgeAccess access = Friends.KNOWLEDGE.of(next);
        DecisionTable table = components.compile(next, false);
        EventNames names = access.eventNames();
        components.monitors().forEach(monitor -> Friends.MONITOR.of(monitor).requireKnown(names));
        Rules running = shell.driver().rules();
        Rules rules = new Rules(table, access::timersOf, running.queueCapacity(), running.pressAge());
        Swap swap = Swap.of(running, rules, evolution.mapping());
        if (evolution.needsWayBack() && !back) {
            Migration there = plan(running, swap, shell.driver().configuration());
            Swap wayBack = Swap.of(rules, running, evolution.mapping().reversed());
            requireWayBack(Migration.plan(rules.table(), wayBack.succession(), there.ends()), rules, running);
        }
        return new Prepared(present, components, swap);
    }

    private static Migration plan(Rules running, Swap swap, Configuration present) {
        return Migration.plan(running.table(), swap.succession(), Set.of(present));
    }

    private static void requireWayBack(Migration back, Rules rules, Rules running) {
        String stuck = back.lines().stream()
                .filter(line -> line.fate() instanceof Fate.Stuck)
                .map(line -> "  " + line.at() + ": " + ((Fate.Stuck) line.fate()).because())
                .collect(Collectors.joining("\n"));
        if (!stuck.isEmpty()) {
            throw new ModelException(
                    "from some states of '" + rules.table().models().evolved().name()
                            + "' no way leads back to '"
                            + running.table().models().evolved().name()
                            + "'; map them, or say that no way back is needed:\n" + stuck);
        }
    }

    /** One attempt, serialised with all other changes. */
    private final class Attempt implements Runnable {
        private final ConverterShell shell;
        private final Evolution evolution;
        private final boolean back;
        private @Nullable Prepared prepared;
        private String hindrance = "";
        private @Nullable Configuration hindered;

        /** Whether no event leads to states in which it is possible. */
        private boolean stuck;

        private Evolution.@Nullable Result result;

        Attempt(ConverterShell shell, Evolution evolution, boolean back) {
            this.shell = shell;
            this.evolution = evolution;
            this.back = back;
        }

        @Override
        public void run() {
            Prepared ready = prepared;
            if (ready == null || ready.components() != assembly.get() || ready.present() != shell.knowledge()) {
                ready = compile(shell, evolution, back);
                shell.driver().prepare(ready.swap().rules());
                prepared = ready;
            }
            StateKnowledge next = evolution.next();
            try {
                List<EventMonitor> monitors = ready.components().monitors();
                result = shell.evolve(ready.swap(), next, evolution.idle(), monitors);
            } catch (EvolutionException notNow) {
                hindrance = String.valueOf(notNow.getMessage());
                look(ready.swap(), shell.driver().configuration());
                return;
            }
            ProbationWatch ending = trial();
            if (ending != null) {
                ending.end();
            }
            forgetShadow(next);
            wayBack = null;
            if (back) {
                ownership.giveBack(ready.present());
            } else if (evolution.needsWayBack()) {
                openWayBack(ready.present());
            }
            // Only now: a listener may read the status, which shows the way back and the probation.
            shell.records().listeners().evolved(result);
        }

        /** Looks once in each pair of states: only another one can lead further. */
        private void look(Swap swap, Configuration at) {
            boolean hinders = swap.succession().fate(at) instanceof Fate.Stuck now
                    && now.because().equals(hindrance);
            if (hinders && !at.equals(hindered)) {
                hindered = at;
                stuck = plan(shell.driver().rules(), swap, at).at(at) instanceof Fate.Stuck;
            }
        }

        /** Opens the way back to {@code previous}, and begins the trial if there is to be one. */
        private void openWayBack(StateKnowledge previous) {
            ProbationWatch trial = evolution.probation().isAny()
                    ? new ProbationWatch(
                            config,
                            shell,
                            evolution.probation(),
                            why -> announce(shell, why),
                            () -> rollBack(shell, Evolution.USUAL_DEADLINE))
                    : null;
            wayBack =
                    new WayBack(evolution.next(), previous, evolution.mapping().reversed(), trial);
            if (trial != null) {
                // From now on a fault rolls back, which needs the way back.
                trial.begin();
            }
        }
    }

    private final class LiveShadow implements Shadow {
        private final ConverterShell shell;
        private final Evolution evolution;

        LiveShadow(ConverterShell shell, Evolution evolution) {
            this.shell = shell;
            this.evolution = evolution;
        }

        @Override
        public Evolution evolution() {
            return evolution;
        }

        @Override
        public ShadowReport report() {
            ShadowReport report = shadow == this ? shell.driver().shadowReport() : null;
            if (report == null) {
                throw new IllegalStateException("the shadow has ended");
            }
            return report;
        }

        @Override
        public Evolution.Result promote() {
            return Evolver.this.promote(this, shell);
        }

        @Override
        public void close() {
            end(this, shell);
        }
    }

    /** The last trial, which may be over; null if there was none. */
    private @Nullable ProbationWatch trial() {
        WayBack back = wayBack;
        return back == null ? null : back.trial();
    }

    /** A step has been taken in a converter without threads. */
    void stepped() {
        ProbationWatch running = trial();
        if (running != null) {
            running.stepped();
        }
    }

    /** By its journal, the converter continues with other models than those with which it was built. */
    void resumed(StateKnowledge built, StateKnowledge present) {
        resumed = built == present ? null : new WayBack(present, built, Mapping.byName(), null);
    }

    /** Describes which models took over from which; empty if that is not known any more. */
    String describe(StateKnowledge present) {
        WayBack back = wayBack;
        WayBack before = resumed;
        if (back != null) {
            ProbationWatch running = back.trial();
            return back.tookOver()
                    + (running == null || running.isOver() ? "" : ", on probation " + running.describe());
        }
        return before == null || before.from() != present ? "" : before.tookOver() + " before the program was started";
    }
}
