package org.evoloop.roomba.simulator;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.webcam.Webcam;
import org.jspecify.annotations.Nullable;

/**
 * Text commands that act on the robot and its room, or show its state. Each command is one line, and so is its answer:
 *
 * <ul>
 *   <li>{@code press clean|spot|dock [MILLIS]}: {@code ok}, the button is down for 150 or MILLIS ms of robot time;
 *       if it is down already, it is released first when its time is over
 *   <li>{@code lift}, {@code set-down}: {@code ok}, the robot is in the air, or back on the floor where it was
 *   <li>{@code place X Y HEADING}: {@code ok}, the robot stands there, in mm and degrees counterclockwise from x
 *   <li>{@code dock}, {@code undock}: {@code ok}, the robot stands on its dock, or half a metre behind
 *   <li>{@code unplug}, {@code replug}: {@code ok}, the client's cable is pulled, or plugged in again
 *   <li>{@code move-marker X Y HEADING}: {@code ok}, the room's marker hangs there
 *   <li>{@code cover-marker}, {@code uncover-marker}: {@code ok}, the marker is covered with a cloth, or uncovered
 *   <li>{@code camera stall|resume}: {@code ok}, pictures stop, or are sent again, undamaged
 *   <li>{@code camera unplug|replug}: {@code ok}, the camera's cable is pulled, or plugged in again
 *   <li>{@code camera damage P}: {@code ok}, this part of its pictures is sent damaged, 0 to 1
 *   <li>{@code state}: the robot's true state in JSON, see {@code RobotState}
 *   <li>{@code help}: these commands
 * </ul>
 *
 * <p>Any other command changes nothing; its answer is {@code error: } and the reason.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class WorldCommands {
    private static final String OK = "ok";
    private static final String PRESS = "press clean|spot|dock [MILLIS]";
    private static final String PLACE = "place X Y HEADING";
    private static final String MOVE_MARKER = "move-marker X Y HEADING";
    private static final String CAMERA = "camera stall|resume|unplug|replug|damage P";
    private static final List<String> USAGES = List.of(
            PRESS,
            "lift",
            "set-down",
            PLACE,
            "dock",
            "undock",
            "unplug",
            "replug",
            MOVE_MARKER,
            "cover-marker",
            "uncover-marker",
            CAMERA,
            "state",
            "help");
    private static final String HELP = String.join("; ", USAGES);

    /** The first word of each command. */
    public static final List<String> NAMES =
            USAGES.stream().map(usage -> usage.replaceFirst(" .*", "")).toList();

    /** The names of the buttons that can be pressed. */
    public static final List<String> BUTTON_NAMES = List.of("clean", "spot", "dock");

    private static final List<Button> BUTTONS = List.of(Button.CLEAN, Button.SPOT, Button.DOCK);
    private static final int LONGEST_PRESS_MILLIS = 60_000;
    private static final int FARTHEST_MM = 100_000;

    private final SimulatedRoomba robot;
    private final @Nullable Cable cable;
    private final @Nullable Webcam camera;

    /** Commands for this robot, without a cable or a camera. */
    public WorldCommands(SimulatedRoomba robot) {
        this(robot, null, null);
    }

    /** Commands for this server's robot, its cable and its camera. */
    public WorldCommands(SimulatorServer server) {
        this(server.robot(), server, server.camera().orElse(null));
    }

    private WorldCommands(SimulatedRoomba robot, @Nullable Cable cable, @Nullable Webcam camera) {
        this.robot = robot;
        this.cable = cable;
        this.camera = camera;
    }

    /** Carries out one line and returns its answer, without a line separator. */
    public String execute(String line) {
        List<String> words = Arrays.asList(line.trim().split("\\s+"));
        try {
            return execute(words.get(0), words.subList(1, words.size()));
        } catch (IllegalArgumentException | IOException mistake) {
            return "error: " + mistake.getMessage();
        }
    }

    private String execute(String command, List<String> arguments) throws IOException {
        switch (command) {
            case "press" -> press(arguments);
            case "place" -> robot.place(pose(PLACE, arguments));
            case "move-marker" -> robot.moveMarker(pose(MOVE_MARKER, arguments));
            case "camera" -> camera(arguments);
            case "lift",
                    "set-down",
                    "dock",
                    "undock",
                    "unplug",
                    "replug",
                    "cover-marker",
                    "uncover-marker",
                    "state",
                    "help" -> {
                requireCount(command, arguments, 0, 0);
                return act(command);
            }
            default -> throw new IllegalArgumentException("'" + command + "' is not a command; there are " + HELP);
        }
        return OK;
    }

    private String act(String command) throws IOException {
        switch (command) {
            case "lift" -> robot.lift();
            case "set-down" -> robot.setDown();
            case "dock" -> robot.dock();
            case "undock" -> robot.undock();
            case "unplug" -> cable().unplug();
            case "replug" -> cable().replug();
            case "cover-marker" -> robot.coverMarker(true);
            case "uncover-marker" -> robot.coverMarker(false);
            case "help" -> {
                return HELP;
            }
            default -> {
                return robot.state().toJson();
            }
        }
        return OK;
    }

    private Cable cable() {
        if (cable == null) {
            throw new IllegalArgumentException("this robot has no cable");
        }
        return cable;
    }

    private void press(List<String> arguments) {
        requireCount(PRESS, arguments, 1, 2);
        Button button = button(arguments.get(0));
        robot.press(button, arguments.size() < 2 ? SimulatedRoomba.USUAL_PRESS_MILLIS : millis(arguments.get(1)));
    }

    private static Button button(String name) {
        return BUTTONS.stream()
                .filter(button -> button.name().toLowerCase(Locale.ROOT).equals(name))
                .findFirst()
                .orElseThrow(() ->
                        new IllegalArgumentException("'" + name + "' is not a button; there are clean, spot and dock"));
    }

    private static int millis(String text) {
        // Seven digits are more than enough, and fit into an int.
        if (!text.matches("\\d{1,7}") || Integer.parseInt(text) < 1 || Integer.parseInt(text) > LONGEST_PRESS_MILLIS) {
            throw new IllegalArgumentException(
                    "MILLIS is '" + text + "'; allowed is 1 to " + LONGEST_PRESS_MILLIS + " ms");
        }
        return Integer.parseInt(text);
    }

    private void camera(List<String> arguments) throws IOException {
        if (camera == null) {
            throw new IllegalArgumentException("this robot has no camera");
        }
        requireCount(CAMERA, arguments, 1, 2);
        String action = arguments.get(0);
        requireCount(CAMERA, arguments, action.equals("damage") ? 2 : 1, action.equals("damage") ? 2 : 1);
        switch (action) {
            case "stall" -> camera.stall();
            case "resume" -> camera.resume();
            case "unplug" -> camera.unplug();
            case "replug" -> camera.replug();
            case "damage" -> camera.damage(number("P", arguments.get(1), 0, 1));
            default -> throw new IllegalArgumentException("the command is '" + CAMERA + "'");
        }
    }

    private static Pose pose(String usage, List<String> arguments) {
        requireCount(usage, arguments, 3, 3);
        return new Pose(
                number("X", arguments.get(0), -FARTHEST_MM, FARTHEST_MM),
                number("Y", arguments.get(1), -FARTHEST_MM, FARTHEST_MM),
                Math.toRadians(number("HEADING", arguments.get(2), -FARTHEST_MM, FARTHEST_MM)));
    }

    private static double number(String name, String text, int least, int most) {
        double number = text.matches("-?\\d{1,7}(\\.\\d{1,7})?") ? Double.parseDouble(text) : Double.NaN;
        if (!(number >= least && number <= most)) {
            throw new IllegalArgumentException(name + " is '" + text + "'; allowed is " + least + " to " + most);
        }
        return number;
    }

    private static void requireCount(String usage, List<String> arguments, int least, int most) {
        if (arguments.size() < least || arguments.size() > most) {
            throw new IllegalArgumentException("the command is '" + usage + "'");
        }
    }
}
