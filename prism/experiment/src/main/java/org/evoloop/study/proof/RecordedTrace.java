package org.evoloop.study.proof;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.engine.Core;
import org.evoloop.engine.Input;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.journal.JournalFiles;
import org.evoloop.journal.JournalRecord;
import org.jspecify.annotations.Nullable;

/**
 * The core's inputs in a recorded run, from its journal: a line for each input, and one for what it knew
 * then.
 *
 * <p>Threading: for one thread.
 */
final class RecordedTrace {
    /** The inputs that a process may get before it is opened. */
    private static final Set<String> PREPARING = Set.of("changed", "observed", "closing");

    private final EvolvingPair evolution;
    private final StringBuilder out = new StringBuilder("> ANEW 0 0 0 0\n");
    private Core core;
    private boolean swapped;

    /** By how much the time of day is before the monotonic clock of the process that was recorded last. */
    private @Nullable Duration offset;

    private RecordedTrace(EvolvingPair evolution) {
        this.evolution = evolution;
        this.core = new Core(evolution.rules(), output -> {});
    }

    /**
     * @param journal its directory; nothing of it must have been deleted yet
     * @throws IllegalArgumentException if it holds what the specification leaves out, or is of other models
     * @throws org.evoloop.journal.JournalException if it cannot be read
     */
    static String of(EvolvingPair evolution, Path journal) {
        RecordedTrace trace = new RecordedTrace(evolution);
        trace.writeState();
        List<JournalRecord> records = new ArrayList<>();
        new JournalFiles(journal).read(records::add);
        for (int index = 0; index < records.size(); index++) {
            if (trace.beginsProcess(records, index)) {
                trace.recover(records.get(index));
            }
            trace.apply(records.get(index));
        }
        return trace.out.toString();
    }

    /**
     * Whether another process continues here: it begins a segment, and is opened although the previous one was never closed.
     */
    private boolean beginsProcess(List<JournalRecord> records, int index) {
        String segment = records.get(index).segment();
        if (index == 0 || segment.equals(records.get(index - 1).segment()) || !core.isOpen()) {
            return false;
        }
        return records.stream()
                .skip(index)
                .filter(record -> !PREPARING.contains(record.kind()))
                .findFirst()
                .filter(record ->
                        record.kind().equals("opened") && record.segment().equals(segment))
                .isPresent();
    }

    private void recover(JournalRecord first) {
        followClock(first);
        line("RECOVERED");
        core.apply(new Input.Recovered(first.nanos()));
        writeState();
    }

    private void apply(JournalRecord recorded) {
        followClock(recorded);
        try {
            if (recorded.number() == 0) {
                line("EVOLVED_TO");
                core.apply(new Input.Evolved(evolution.swap(swapped), recorded.nanos()));
                swapped ^= true;
            } else {
                line(recorded.input());
                core.apply(recorded.input());
            }
        } catch (IllegalArgumentException leftOut) {
            throw new IllegalArgumentException(place(recorded) + ": " + leftOut.getMessage(), leftOut);
        }
        writeState();
        if (!core.at().equals(recorded.where())
                || core.doubt().isEmpty() != recorded.doubt().isEmpty()) {
            throw new IllegalArgumentException(
                    place(recorded) + ": the run was in " + recorded.where() + " then, not in " + core.at()
                            + "; it is of other models, timers or device events, or does not begin with its first record");
        }
    }

    private static String place(JournalRecord recorded) {
        return recorded.segment() + ", record " + recorded.number();
    }

    /** The monotonic clocks of two processes are unrelated; the time of day says how much time passed in between. */
    private void followClock(JournalRecord recorded) {
        Duration now = Duration.between(Instant.EPOCH.plusNanos(recorded.nanos()), recorded.at());
        Duration before = offset;
        if (before != null && !before.equals(now)) {
            core = new Core(
                    evolution.rules(swapped),
                    core.snapshot().later(before.minus(now).toNanos()),
                    output -> {});
        }
        offset = now;
    }

    private void writeState() {
        out.append(StateText.of(evolution, core.snapshot(), swapped)).append('\n');
    }

    private void line(String name, long... arguments) {
        out.append("> ").append(name);
        for (int index = 0; index < 4; index++) {
            out.append(' ').append(index < arguments.length ? arguments[index] : 0);
        }
        out.append('\n');
    }

    private void line(Input input) {
        if (input instanceof Input.Opened) {
            line("OPENED");
        } else if (input instanceof Input.Closing) {
            line("CLOSING");
        } else if (input instanceof Input.Closed) {
            line("CLOSED");
        } else if (input instanceof Input.Recovered) {
            line("RECOVERED");
        } else if (input instanceof Input.Ready) {
            line("READY_FOR");
        } else if (input instanceof Input.Changed) {
            line("CHANGED");
        } else if (input instanceof Input.TimerDue due) {
            line("TIMER_DUE", due.visit() == core.snapshot().visit().number() ? 0 : 1);
        } else if (input instanceof Input.Observed observed) {
            line(observed.occurrence());
        } else {
            lineOfWork(input);
        }
    }

    private void line(Occurrence occurrence) {
        StateText.Numbers numbers = StateText.numbers(evolution, core.snapshot(), occurrence);
        if (occurrence instanceof Occurrence.Heard heard) {
            line("HEARD_OF", numbers.what(), numbers.source(), numbers.visit(), heard.deviceActed() ? 1 : 0);
        } else if (occurrence instanceof Occurrence.Asked) {
            line("ASKED_OF", numbers.what(), numbers.visit());
        } else if (occurrence instanceof Occurrence.Found found) {
            line(
                    "FOUND_AT",
                    numbers.what(),
                    found.observedNanos() < core.snapshot().lastStepNanos() ? 1 : 0);
        } else {
            throw leftOut(occurrence.label());
        }
    }

    private static IllegalArgumentException leftOut(String what) {
        return new IllegalArgumentException("the specification leaves out " + what + "; record a run without it");
    }

    /** What became of the occurrence in progress. */
    private void lineOfWork(Input input) {
        if (input instanceof Input.Planned planned) {
            Decision decision = planned.decision();
            line(
                    "PLANNED",
                    planned.number(),
                    Codes.of(decision, evolution),
                    evolution.number(decision.deviceStart(), true),
                    evolution.number(decision.before().evolved(), false));
        } else if (input instanceof Input.Dismissed dismissed) {
            line("DISMISSED", dismissed.number());
        } else if (input instanceof Input.Sending sending) {
            line("SENDING_IT", sending.number());
        } else if (input instanceof Input.Sent sent) {
            line("WAS_SENT", sent.number(), sent.inOrder() ? 1 : 0);
        } else if (input instanceof Input.Failed failed) {
            line("FAILED", failed.number());
        } else if (input instanceof Input.GivenUp givenUp) {
            line("GIVEN_UP", givenUp.number());
        } else if (input instanceof Input.Located located) {
            line("LOCATED", located.number(), located.state() == null ? 0 : evolution.number(located.state(), true));
        } else {
            throw leftOut("what was recorded here");
        }
    }
}
