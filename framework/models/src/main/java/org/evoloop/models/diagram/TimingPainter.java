package org.evoloop.models.diagram;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import org.evoloop.svg.Svg;

/**
 * Draws a timing diagram in UML's notation: a lane for each lifeline, a level for each state, time from left to right.
 * Each event has its own column, so that durations that differ a thousandfold stay readable side by side.
 */
final class TimingPainter {
    static final String STYLE = """
            .tick { stroke: #ccc; stroke-dasharray: 3 3 }
            .lifeline { fill: none; stroke: #a3159a; stroke-width: 2.5 }
            .level { stroke: #eee }
            .lane { font-weight: bold }
            """;

    private static final double TITLE = 28;

    /** The font size of headings, relative to other text. */
    private static final double HEADING = 1.31;

    private static final double LEVEL = 24;
    private static final double LANE = 22;
    private static final double PADDING = 10;
    private static final double TAIL = 30;

    private final Timing timing;
    private final List<List<String>> levels = new ArrayList<>();
    private final double names;
    private final double[] columns;

    TimingPainter(Timing timing) {
        this.timing = timing;
        double widest = 0;
        for (int lane = 0; lane < timing.lifelines().size(); lane++) {
            LinkedHashSet<String> states = new LinkedHashSet<>();
            for (Timing.Moment moment : timing.moments()) {
                states.add(moment.states().get(lane));
            }
            states.remove("");
            levels.add(List.copyOf(states));
            widest = Math.max(widest, TextSize.width(levels.get(lane), false));
            widest = Math.max(widest, TextSize.width(timing.lifelines().get(lane), true));
        }
        names = widest + 2 * PADDING;
        columns = new double[timing.moments().size() + 1];
        columns[0] = names + PADDING;
        for (int index = 0; index < timing.moments().size(); index++) {
            Timing.Moment moment = timing.moments().get(index);
            double text = Math.max(TextSize.width(moment.what(), false), TextSize.width(moment.time(), false));
            columns[index + 1] = columns[index] + Math.max(TAIL, text) + 2 * PADDING;
        }
    }

    double width() {
        return Math.max(
                columns[columns.length - 1] + PADDING, TextSize.width(timing.title(), true) * HEADING + 2 * PADDING);
    }

    double height() {
        double height = TITLE + LANE + PADDING;
        for (List<String> states : levels) {
            height += LANE + states.size() * LEVEL;
        }
        return height + LANE;
    }

    /** Draws the diagram at the origin of the group opened last. */
    void paint(Svg svg) {
        svg.rectangle("border", 0, 0, width(), height(), 4);
        svg.text("heading", PADDING, TextSize.ASCENT + PADDING, timing.title());
        double bottom = height() - LANE;
        for (int index = 0; index < timing.moments().size(); index++) {
            Timing.Moment moment = timing.moments().get(index);
            svg.line("tick", columns[index], TITLE + LANE, columns[index], bottom);
            svg.text("what", columns[index], TITLE + LANE - PADDING / 2, moment.what());
            svg.text("time", columns[index], bottom + TextSize.ASCENT + PADDING / 2, moment.time());
        }
        double top = TITLE + LANE + PADDING;
        for (int lane = 0; lane < levels.size(); lane++) {
            lifeline(svg, lane, top);
            top += LANE + levels.get(lane).size() * LEVEL;
        }
    }

    private void lifeline(Svg svg, int lane, double top) {
        List<String> states = levels.get(lane);
        svg.text("lane", PADDING, top + TextSize.ASCENT, timing.lifelines().get(lane));
        for (int level = 0; level < states.size(); level++) {
            double y = top + LANE + level * LEVEL + LEVEL / 2;
            svg.line("level", names, y, columns[columns.length - 1], y);
            svg.text("state", 2 * PADDING, y + TextSize.ASCENT / 3, states.get(level));
        }
        StringBuilder path = new StringBuilder();
        for (int index = 0; index < timing.moments().size(); index++) {
            int level = states.indexOf(timing.moments().get(index).states().get(lane));
            double y = top + LANE + level * LEVEL + LEVEL / 2;
            boolean continues = index > 0
                    && !timing.moments().get(index - 1).states().get(lane).isEmpty();
            if (level >= 0) {
                path.append(continues ? " L" : " M").append(Svg.pair(columns[index], y));
                path.append(" L").append(Svg.pair(columns[index + 1], y));
            }
        }
        if (!path.isEmpty()) {
            svg.path("lifeline", path.toString().strip());
        }
    }
}
