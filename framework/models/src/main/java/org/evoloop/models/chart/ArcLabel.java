package org.evoloop.models.chart;

import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.statechart.Arc;

/** The label of a transition in UML's notation. */
public final class ArcLabel {
    private ArcLabel() {}

    /** {@code trigger, trigger [guard] / effect; effect {local}}; missing parts are left out. */
    public static String of(Arc arc) {
        String label = of(triggers(arc), arc.guard(), arc.effects());
        return arc.kind() == Arc.Kind.LOCAL ? (label + " {local}").strip() : label;
    }

    /** The triggers of a transition, with their keywords. */
    public static String triggers(Arc arc) {
        return arc.triggers().stream()
                .map(trigger -> arc.keywords(trigger) + trigger)
                .collect(Collectors.joining(", "));
    }

    /** Builds the label from its parts, each of which may be empty. */
    public static String of(String triggers, String guard, List<String> effects) {
        StringBuilder label = new StringBuilder(triggers);
        if (!guard.isEmpty()) {
            label.append(label.length() == 0 ? "" : " ")
                    .append('[')
                    .append(guard)
                    .append(']');
        }
        if (!effects.isEmpty()) {
            label.append(label.length() == 0 ? "" : " ").append("/ ").append(String.join("; ", effects));
        }
        return label.toString();
    }
}
