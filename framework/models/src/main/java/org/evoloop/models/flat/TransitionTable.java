package org.evoloop.models.flat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.statechart.DeviceUse;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * A flat machine as a table, one line per transition. For a state and an event, the first transition whose guard holds
 * is taken.
 */
public final class TransitionTable {
    private static final List<String> HEAD = List.of("state", "event", "guard", "effects", "next state");

    private TransitionTable() {}

    public static String write(StateMachine machine) {
        List<List<String>> rows = new ArrayList<>();
        rows.add(HEAD);
        machine.transitions().forEach(transition -> rows.add(row(transition)));
        int[] widths = new int[HEAD.size()];
        for (List<String> row : rows) {
            for (int column = 0; column < widths.length; column++) {
                widths[column] = Math.max(widths[column], width(row.get(column)));
            }
        }
        StringBuilder text = new StringBuilder();
        String initially =
                machine.initialEffects().isEmpty() ? "" : " / " + String.join("; ", machine.initialEffects());
        line(text, machine + ", starts in " + machine.initial() + initially);
        for (State state : machine.states()) {
            DeviceUse use = DeviceUse.of(machine, state);
            if (!use.device().isEmpty()) {
                line(text, state + " has the device in " + use.device());
            }
            if (!use.sends().isEmpty()) {
                line(text, state + " may send " + String.join("; ", use.sends()));
            }
            if (!machine.activities(state).isEmpty()) {
                line(text, state + " does " + String.join("; ", machine.activities(state)));
            }
            if (!machine.deferred(state).isEmpty()) {
                line(
                        text,
                        state + " defers "
                                + machine.deferred(state).stream()
                                        .map(Event::toString)
                                        .collect(Collectors.joining("; ")));
            }
        }
        for (List<String> row : rows) {
            StringBuilder line = new StringBuilder();
            for (int column = 0; column < widths.length; column++) {
                String cell = row.get(column);
                line.append(cell).append(" ".repeat(widths[column] - width(cell) + 2));
            }
            line(text, line.toString().stripTrailing());
        }
        return text.toString();
    }

    /** Effects and guards of several lines would break the table. */
    private static void line(StringBuilder text, String line) {
        text.append(Names.inOneLine(line)).append('\n');
    }

    private static List<String> row(Transition transition) {
        return List.of(
                transition.source().name(),
                transition.event().name(),
                String.join("] [", transition.event().guards()),
                String.join("; ", transition.effects()),
                transition.target() + (transition.internal() ? " (internal)" : ""));
    }

    /** The width in terminal columns; Chinese, Japanese and Korean characters take two. */
    private static int width(String cell) {
        return cell.codePoints().map(point -> point >= 0x1100 ? 2 : 1).sum();
    }
}
