package org.evoloop.page.drawing;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.evoloop.evolution.ModelPair;
import org.evoloop.page.drawing.Graph.Arrow;
import org.evoloop.page.drawing.Graph.Box;
import org.evoloop.page.drawing.Graph.Frame;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * The drawing of a machine, as SVG without colours: a style sheet gives them, by the classes {@code state} with its
 * {@code box} and {@code name}, {@code transition} with its {@code line}, {@code event} with its {@code label}, and
 * {@code added}. Elements are identified, so that a program can highlight them: {@code data-state} on states; {@code
 * data-source} and {@code data-target} on transitions, and also {@code data-event} on events.
 *
 * <p>States that differ only in what the machine remembers are one, and a composite state is a frame around its states.
 */
public final class MachineDrawing {
    /** A larger drawing would be unreadable, and its layout would take long. */
    static final int MOST_TRANSITIONS = 400;

    private static final double MARGIN = 16;

    private final StateMachine machine;
    private final Sketch sketch;
    private final Graph graph;
    private final Set<State> added = new HashSet<>();
    private final StringBuilder svg = new StringBuilder();

    private MachineDrawing(StateMachine machine, Sketch sketch, Predicate<State> isAdded) {
        this.machine = machine;
        this.sketch = sketch;
        machine.states().stream().filter(isAdded).map(machine::withoutMemory).forEach(added::add);
        graph = new Graph(sketch);
        Rows.arrange(graph);
    }

    /**
     * Draws {@code machine}.
     *
     * @param added the states to mark
     * @return empty if it is too large to be drawn
     */
    public static String of(StateMachine machine, Predicate<State> added) {
        return of(machine, Sketch.of(machine, false), added);
    }

    /**
     * Draws {@code machine} with each composite state as one box.
     *
     * @return empty if it has none, or is too large all the same
     */
    public static String overview(StateMachine machine, Predicate<State> added) {
        return Sketch.of(machine, false).hasComposites() ? of(machine, Sketch.of(machine, true), added) : "";
    }

    /**
     * Draws the new model of a pair or, if that would be wider, only the transitions that the original one has not.
     *
     * @return empty if it is too large all the same
     */
    public static String ofNew(ModelPair models, int widest) {
        StateMachine machine = models.evolved();
        Sketch all = Sketch.of(machine, false);
        if (isTooLarge(all)) {
            return "";
        }
        MachineDrawing whole = new MachineDrawing(machine, all, models::isNew);
        Sketch more = all.without(Sketch.of(models.original(), false));
        return whole.width() <= widest || more.arrows().isEmpty()
                ? whole.draw()
                : new MachineDrawing(machine, more, models::isNew).draw();
    }

    /** The composite states in which {@code state} is drawn, the outermost first. */
    public static List<String> around(StateMachine machine, State state) {
        return Sketch.around(machine, state);
    }

    private static String of(StateMachine machine, Sketch sketch, Predicate<State> added) {
        return isTooLarge(sketch) ? "" : new MachineDrawing(machine, sketch, added).draw();
    }

    private static boolean isTooLarge(Sketch sketch) {
        return Math.max(sketch.arrows().size(), sketch.around().size()) > MOST_TRANSITIONS;
    }

    private double width() {
        return graph.rows.stream()
                .flatMap(List::stream)
                .mapToDouble(box -> box.x + box.width / 2 + margin())
                .max()
                .orElse(0);
    }

    private double margin() {
        return MARGIN + Graph.PADDING * Math.max(1, graph.depth());
    }

    private String draw() {
        double width = width();
        double height = 0;
        for (List<Box> row : graph.rows) {
            for (Box box : row) {
                height = Math.max(height, box.y + box.height / 2 + margin());
            }
        }
        svg.append(format(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" height=\"%.0f\">",
                width, height, width, height));
        graph.frames.forEach(this::frame);
        graph.arrows.forEach(this::line);
        Box initial = graph.box(sketch.initial());
        double top = initial.y - initial.height / 2;
        svg.append(format(
                "<g class=\"pseudostate\"><circle class=\"solid\" cx=\"%.1f\" cy=\"%.1f\" r=\"5\"/></g>"
                        + "<g class=\"transition\"><path class=\"line way\" d=\"M%.1f %.1fV%.1f\"/></g>",
                initial.x, top - 20, initial.x, top - 20, top));
        graph.states.forEach(this::state);
        graph.arrows.forEach(this::events);
        return svg.append("</svg>").toString();
    }

    /** A composite state, around its states. */
    private void frame(Frame frame) {
        double left = Double.MAX_VALUE;
        double top = Double.MAX_VALUE;
        double right = 0;
        double bottom = 0;
        for (Box box : frame.states()) {
            int levels = graph.levels(frame, box);
            double beside = box.width / 2 + levels * Graph.PADDING;
            double below = box.height / 2 + levels * Graph.PADDING;
            left = Math.min(left, box.x - beside);
            right = Math.max(right, box.x + beside);
            top = Math.min(top, box.y - below - levels * Graph.TITLE);
            bottom = Math.max(bottom, box.y + below);
        }
        String name = frame.path().get(frame.path().size() - 1);
        svg.append(format(
                "<g class=\"composite\" data-composite=\"%s\"><rect class=\"box frame\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\""
                        + " height=\"%.1f\" rx=\"12\"/><text class=\"title\" x=\"%.1f\" y=\"%.1f\">%s</text></g>",
                escape(String.join(".", frame.path())),
                left,
                top,
                right - left,
                bottom - top,
                left + Graph.PADDING,
                top + 18,
                escape(name)));
    }

    private void state(State state, Box box) {
        svg.append(format(
                "<g class=\"state%s\" data-state=\"%s\"><rect class=\"box\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" rx=\"12\"/>"
                        + "<text class=\"name\" x=\"%.1f\" y=\"%.1f\">%s</text>%s</g>",
                added.contains(state) ? " added" : "",
                escape(state.name()),
                box.x - box.width / 2,
                box.y - box.height / 2,
                box.width,
                box.height,
                box.x,
                box.y + 5,
                escape(state.name()),
                device(state)));
    }

    /** What a state has to do with the device, which a browser shows when it is pointed at; empty for most. */
    private String device(State state) {
        String device = machine.deviceState(state);
        String where = device == null ? "" : ModelPair.describe(state, device);
        String sent = machine.sends(state).stream().map(Event::name).collect(Collectors.joining(", "));
        String text =
                where + (where.isEmpty() || sent.isEmpty() ? "" : "; ") + (sent.isEmpty() ? "" : "may send " + sent);
        return text.isEmpty() ? "" : "<title>" + escape(text) + "</title>";
    }

    private String ends(Arrow arrow) {
        String tone = added.contains(arrow.source()) || added.contains(arrow.target()) ? " added\"" : "\"";
        return tone + " data-source=\"" + escape(arrow.source().name()) + "\" data-target=\""
                + escape(arrow.target().name()) + "\"";
    }

    private void line(Arrow arrow) {
        svg.append("<g class=\"transition").append(ends(arrow)).append("><path class=\"line way\" d=\"");
        svg.append(Course.of(arrow)).append("\"/></g>");
    }

    private void events(Arrow arrow) {
        Box label = arrow.label();
        double y = label.y - label.height / 2 + Graph.LINE - 2;
        for (Sketch.Line line : arrow.lines()) {
            svg.append(format(
                    "<g class=\"event%s data-event=\"%s\"><text class=\"label middle\" x=\"%.1f\" y=\"%.1f\">%s</text></g>",
                    ends(arrow), escape(line.event()), label.x, y, escape(line.text())));
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
