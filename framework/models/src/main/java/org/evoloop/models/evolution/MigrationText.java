package org.evoloop.models.evolution;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.migration.Carried;
import org.evoloop.migration.Fate;
import org.evoloop.migration.Migration;
import org.evoloop.statemachine.Event;

/** A swap's plan as text. */
public final class MigrationText {
    private MigrationText() {}

    public static String write(ModelPair before, ModelPair after, Migration migration) {
        List<String> lines = new ArrayList<>();
        lines.add("from " + before.evolved() + " to " + after.evolved() + ", with the device " + device(before, after));
        lines.add("(device, system)");
        migration.lines().forEach(line -> lines.add(line.at() + "  " + what(line.fate(), after)));
        lines.add(sum(migration));
        // A state of the new model may wait in many states of the device; the remedy is printed only once.
        migration.lines().stream()
                .map(Migration.Line::fate)
                .filter(Fate.Waits.class::isInstance)
                .map(fate -> "waiting, because " + ((Fate.Waits) fate).because())
                .distinct()
                .forEach(lines::add);
        return String.join("\n", lines) + "\n";
    }

    private static String device(ModelPair before, ModelPair after) {
        String was = before.original().name();
        String is = after.original().name();
        return was.equals(is) ? was : "from " + was + " to " + is;
    }

    private static String what(Fate fate, ModelPair after) {
        if (fate instanceof Fate.Maps maps) {
            String carried = maps.carried().stream().map(Carried::toString).collect(Collectors.joining(", "));
            String system = after.describe(maps.to());
            return (maps.steps().isEmpty() ? "maps to " : "by sending " + way(maps.steps()) + " to ")
                    + maps.to()
                    + (carried.isEmpty() ? "" : ": " + carried)
                    + (system.equals(maps.to().evolved().name()) ? "" : "; " + system);
        } else if (fate instanceof Fate.Waits waits) {
            return "waits until " + names(waits.exits(), " or ") + " leads out"
                    + (waits.uncertain().isEmpty() ? "" : "; may never come: " + names(waits.uncertain(), ", "));
        }
        return "IMPOSSIBLE, because " + ((Fate.Stuck) fate).because();
    }

    private static String way(List<Step> steps) {
        return steps.stream().map(step -> step.trigger().name()).collect(Collectors.joining(", "));
    }

    private static String names(List<Event> events, String between) {
        return events.stream().map(Event::toString).collect(Collectors.joining(between));
    }

    private static String sum(Migration migration) {
        long maps = count(migration, FateKind.MAPS);
        long sending = count(migration, FateKind.SENDS);
        long waits = count(migration, FateKind.WAITS);
        long impossible = count(migration, FateKind.IMPOSSIBLE);
        return migration.lines().size() + " pairs of states: " + maps + " map, " + sending + " by sending, " + waits
                + " wait, " + impossible + " impossible";
    }

    private static long count(Migration migration, FateKind kind) {
        return migration.lines().stream()
                .filter(line -> FateKind.of(line.fate()) == kind)
                .count();
    }
}
