package org.evoloop.page.drawing;

import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.evoloop.evolution.ModelPair;
import org.evoloop.page.drawing.Graph.Arrow;
import org.evoloop.page.drawing.Graph.Box;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * The drawing of a machine, as SVG without colours: a style sheet gives them, by the classes {@code state}, {@code
 * new}, {@code arrow} and {@code label}. Elements are identified, so that a program can highlight them: {@code
 * data-state} on states; {@code data-source} and {@code data-target} on arrows, and also {@code data-event} on labels.
 */
public final class MachineDrawing {
    /** A larger drawing would be unreadable, and its layout would take long. */
    static final int MOST_TRANSITIONS = 400;

    private static final double MARGIN = 16;

    private final Graph graph;
    private final StringBuilder svg = new StringBuilder();

    private MachineDrawing(StateMachine machine) {
        graph = new Graph(machine);
        Rows.arrange(graph);
    }

    /**
     * Draws {@code machine}.
     *
     * @param added the states to mark
     * @return empty if it is too large to be drawn
     */
    public static String of(StateMachine machine, Predicate<State> added) {
        if (machine.transitions().size() > MOST_TRANSITIONS || machine.states().size() > MOST_TRANSITIONS) {
            return "";
        }
        return new MachineDrawing(machine).draw(machine, added);
    }

    private String draw(StateMachine machine, Predicate<State> added) {
        double width = 0;
        double height = 0;
        for (List<Box> row : graph.rows) {
            for (Box box : row) {
                width = Math.max(width, box.x + box.width / 2 + MARGIN);
                height = Math.max(height, box.y + box.height / 2 + MARGIN);
            }
        }
        svg.append(format(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" height=\"%.0f\">",
                width, height, width, height));
        graph.arrows.forEach(this::draw);
        Box initial = graph.box(machine.initial());
        double top = initial.y - initial.height / 2;
        svg.append(format("<circle class=\"initial\" cx=\"%.1f\" cy=\"%.1f\" r=\"5\"/>", initial.x, top - 20));
        svg.append(format(
                "<path class=\"initial\" d=\"M%.1f %.1fV%.1fM%.1f %.1fl5 -7M%.1f %.1fl-5 -7\"/>",
                initial.x, top - 20, top, initial.x, top, initial.x, top));
        graph.states.forEach((state, box) -> draw(state, box, added.test(state), machine));
        return svg.append("</svg>").toString();
    }

    private void draw(State state, Box box, boolean added, StateMachine machine) {
        svg.append(format(
                "<g class=\"state%s\" data-state=\"%s\"><rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" rx=\"10\"/>"
                        + "<text x=\"%.1f\" y=\"%.1f\">%s</text>%s</g>",
                added ? " new" : "",
                escape(state.name()),
                box.x - box.width / 2,
                box.y - box.height / 2,
                box.width,
                box.height,
                box.x,
                box.y + 5,
                escape(state.name()),
                device(state, machine)));
    }

    /** What a state has to do with the device, which a browser shows when it is pointed at; empty for most. */
    private static String device(State state, StateMachine machine) {
        String device = machine.deviceState(state);
        String where = device == null ? "" : ModelPair.describe(state, device);
        String sent = machine.sends(state).stream().map(Event::name).collect(Collectors.joining(", "));
        String text =
                where + (where.isEmpty() || sent.isEmpty() ? "" : "; ") + (sent.isEmpty() ? "" : "may send " + sent);
        return text.isEmpty() ? "" : "<title>" + escape(text) + "</title>";
    }

    private void draw(Arrow arrow) {
        String ends = "data-source=\"" + escape(arrow.source().name()) + "\" data-target=\""
                + escape(arrow.target().name()) + "\"";
        svg.append("<g class=\"arrow\" ").append(ends).append("><path d=\"");
        svg.append(Course.of(arrow)).append("\"/></g>");
        Box label = arrow.label();
        double y = label.y - label.height / 2 + Graph.LINE - 2;
        for (Transition transition : arrow.transitions()) {
            svg.append(format(
                    "<text class=\"label\" %s data-event=\"%s\" x=\"%.1f\" y=\"%.1f\">%s</text>",
                    ends, escape(transition.event().toString()), label.x, y, escape(Graph.text(transition))));
            y += Graph.LINE;
        }
    }

    static String format(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }

    /** As text and in attributes; characters that XML does not have become a mark. */
    private static String escape(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;")
                .replaceAll("[\\x00-\\x1F\\uFFFE\\uFFFF]", " ");
    }
}
