package org.evoloop.roomba.simulator;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;

/**
 * What people do to the robot, and see of it, as text. Each command is one line and has one line for an answer:
 *
 * <ul>
 *   <li>{@code press clean|spot|dock [MILLIS]}: {@code ok}, the button is down for 150 or so many ms of robot time
 *   <li>{@code state}: the robot's true state in JSON, see {@code RobotState}
 *   <li>{@code quit}: {@code ok}, and from now on {@link #hasQuit()}
 * </ul>
 *
 * <p>Everything else is answered by {@code error: } and what is wrong.
 *
 * <p>Threading: thread-safe.
 */
public final class WorldCommands {
    private static final String OK = "ok";
    private static final List<Button> BUTTONS = List.of(Button.CLEAN, Button.SPOT, Button.DOCK);
    private static final int LONGEST_PRESS_MILLIS = 60_000;

    private final SimulatedRoomba robot;
    private volatile boolean quit;

    /** Commands for this robot. */
    public WorldCommands(SimulatedRoomba robot) {
        this.robot = robot;
    }

    /** Carries out one line and returns its answer, without a line's end. */
    public String execute(String line) {
        List<String> words = Arrays.asList(line.trim().split("\\s+"));
        try {
            return execute(words.get(0), words.subList(1, words.size()));
        } catch (IllegalArgumentException mistake) {
            return "error: " + mistake.getMessage();
        }
    }

    /** Whether somebody wants the simulator to end. */
    public boolean hasQuit() {
        return quit;
    }

    private String execute(String command, List<String> arguments) {
        return switch (command) {
            case "press" -> press(arguments);
            case "state" -> {
                requireCount("state", arguments, 0, 0);
                yield robot.state().toJson();
            }
            case "quit" -> {
                requireCount("quit", arguments, 0, 0);
                quit = true;
                yield OK;
            }
            default ->
                throw new IllegalArgumentException("'" + command + "' is no command, there are press, state and quit");
        };
    }

    private String press(List<String> arguments) {
        requireCount("press clean|spot|dock [MILLIS]", arguments, 1, 2);
        Button button = button(arguments.get(0));
        robot.press(button, arguments.size() < 2 ? SimulatedRoomba.USUAL_PRESS_MILLIS : millis(arguments.get(1)));
        return OK;
    }

    private static Button button(String name) {
        return BUTTONS.stream()
                .filter(button -> button.name().toLowerCase(Locale.ROOT).equals(name))
                .findFirst()
                .orElseThrow(() ->
                        new IllegalArgumentException("'" + name + "' is no button, there are clean, spot and dock"));
    }

    private static int millis(String text) {
        // Seven digits are more than enough, and fit into an int.
        if (!text.matches("\\d{1,7}") || Integer.parseInt(text) < 1 || Integer.parseInt(text) > LONGEST_PRESS_MILLIS) {
            throw new IllegalArgumentException(
                    "MILLIS is '" + text + "'; allowed is 1 to " + LONGEST_PRESS_MILLIS + " ms");
        }
        return Integer.parseInt(text);
    }

    private static void requireCount(String usage, List<String> arguments, int least, int most) {
        if (arguments.size() < least || arguments.size() > most) {
            throw new IllegalArgumentException("the command is '" + usage + "'");
        }
    }
}
