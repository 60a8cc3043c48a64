package org.evoloop.models.evolution;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.chart.ArcLabel;
import org.evoloop.models.evolution.ModelDifference.Parts;
import org.evoloop.statemachine.Transition;

/** A difference as text. */
public final class DifferenceText {
    private static final String NONE = "-";

    private DifferenceText() {}

    public static String write(ModelPair pair) {
        ModelDifference difference = ModelDifference.of(pair);
        List<String> lines = new ArrayList<>();
        lines.add("from " + pair.original() + " to " + pair.evolved());
        if (!pair.original().initial().equals(pair.evolved().initial())) {
            lines.add("  starts in " + pair.evolved().initial() + ", before in "
                    + pair.original().initial());
        }
        names(lines, "states", difference.states());
        names(lines, "events", difference.events());
        if (!difference.uses().isEmpty()) {
            lines.add("device");
            difference.uses().forEach(change -> lines.add(use(change)));
        }
        lines.add("transitions");
        transitions(lines, "kept", difference.transitions().kept());
        transitions(lines, "added", difference.transitions().added());
        for (ModelDifference.Rerouted rerouted : difference.rerouted()) {
            lines.add("  rerouted  " + label(rerouted.after()) + "  (before: " + label(rerouted.before()) + ")");
        }
        transitions(lines, "removed", difference.transitions().removed());
        return String.join("\n", lines) + "\n";
    }

    private static String use(ModelDifference.UseChange change) {
        String kind = change.before().isNone() ? "added" : change.after().isNone() ? "removed" : "changed";
        return String.format("  %-9s ", kind) + change.state() + " "
                + (change.after().isNone() ? change.before() : change.after()).keywords()
                + (kind.equals("changed") ? "  (before: " + change.before().keywords() + ")" : "");
    }

    private static <T> void names(List<String> lines, String what, Parts<T> parts) {
        lines.add(what);
        lines.add("  kept      " + list(parts.kept()));
        lines.add("  added     " + list(parts.added()));
        lines.add("  removed   " + list(parts.removed()));
    }

    private static <T> String list(List<T> parts) {
        return parts.isEmpty()
                ? NONE
                : String.join(", ", parts.stream().map(Object::toString).toList());
    }

    private static void transitions(List<String> lines, String what, List<Transition> transitions) {
        transitions.forEach(transition -> lines.add(String.format("  %-9s %s", what, label(transition))));
    }

    /** {@code Off --Clean / beep--> On}. */
    static String label(Transition transition) {
        String effects = ArcLabel.of("", "", transition.effects());
        return transition.source() + " --" + transition.event() + (effects.isEmpty() ? "" : " " + effects) + "--> "
                + transition.target() + (transition.internal() ? " (internal)" : "");
    }
}
