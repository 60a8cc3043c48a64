package org.evoloop.models.evolution;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.models.evolution.Bypass.Kind;
import org.evoloop.models.evolution.Bypass.Line;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/** A bypass as text. */
public final class BypassText {
    private BypassText() {}

    public static String write(Bypass bypass) {
        List<String> lines = new ArrayList<>();
        lines.add("bypass from " + bypass.pair().original() + " to "
                + bypass.pair().evolved() + ": events are passed on unchanged while the converter is down");
        lines.add("(device, system)");
        bypass.lines().forEach(line -> lines.add(line.at() + "  " + line.event() + ":  " + what(line)));
        bypass.stopped().forEach(at -> lines.add(at + "  " + stopped(at, bypass)));
        lines.add(bypass.lines().size() + " events in pairs of states: " + count(bypass, Kind.SAME) + " the same, "
                + count(bypass, Kind.OTHER) + " something else, " + count(bypass, Kind.IGNORED) + " ignored, "
                + count(bypass, Kind.UNKNOWN) + " unknown");
        return String.join("\n", lines) + "\n";
    }

    private static String what(Line line) {
        return switch (line.kind()) {
            case SAME ->
                "the same: the device goes to " + line.device()
                        + (line.decision() instanceof Decision.NewState ? rest(line) : "");
            case OTHER -> "something else: the device goes to " + line.device() + rest(line);
            case IGNORED -> "ignored by the device in " + line.device() + rest(line);
            case UNKNOWN -> "unknown to the device, which stays in " + line.device() + rest(line);
        };
    }

    private static String rest(Line line) {
        return "; the converter " + would(line.decision()) + "; found again as " + line.found();
    }

    private static String would(Decision decision) {
        if (decision instanceof Decision.Impossible) {
            return "could not do it";
        } else if (decision instanceof Decision.NotAcceptable) {
            return "would ignore it";
        }
        String sent =
                decision.steps().stream().map(step -> step.trigger().name()).collect(Collectors.joining(", "));
        return "would " + (sent.isEmpty() ? "send nothing" : "send " + sent) + " and be in " + decision.after();
    }

    private static String stopped(Configuration at, Bypass bypass) {
        String timers = bypass.pair().evolved().timers(at.evolved()).keySet().stream()
                .map(Event::toString)
                .collect(Collectors.joining(", "));
        List<String> parts = new ArrayList<>();
        if (bypass.pair().isNew(at.evolved())) {
            parts.add("the function of " + at.evolved() + " does not run");
        }
        if (!timers.isEmpty()) {
            parts.add("no timer runs for " + timers);
        }
        return String.join(", ", parts) + ": the device " + leaves(at.original(), bypass);
    }

    /** What becomes of the device in a state while nothing is sent to it. */
    private static String leaves(State original, Bypass bypass) {
        String own = bypass.pair().original().transitionsFrom(original).stream()
                .map(transition -> transition.event().trigger())
                .filter(bypass.pair().original().spontaneous()::contains)
                .map(Event::toString)
                .distinct()
                .collect(Collectors.joining(" or "));
        return own.isEmpty() ? "stays in " + original : "is in " + original + " until " + own;
    }

    private static long count(Bypass bypass, Kind kind) {
        return bypass.lines().stream().filter(line -> line.kind() == kind).count();
    }
}
