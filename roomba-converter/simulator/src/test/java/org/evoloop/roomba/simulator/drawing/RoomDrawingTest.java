package org.evoloop.roomba.simulator.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.roomba.simulator.room.Point;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.Shape;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

class RoomDrawingTest {
    private static final Shape CLIFF =
            new Shape(Shape.Kind.CLIFF, List.of(new Point(3_000, 0), new Point(3_500, 0), new Point(3_000, 900)));

    private final Trail trail = new Trail();
    private final SimulatedRoomba robot = new SimulatedRoomba(
            RobotOptions.builder()
                    .room(Room.of(List.of(CLIFF), new Pose(-800, 0, Math.PI), new Pose(100, 200, 0)))
                    .build(),
            bytes -> {});

    private void send(Command... commands) {
        for (Command command : commands) {
            robot.receive(command.bytes(), command.bytes().length);
        }
    }

    private void seconds(int seconds) {
        for (int tick = 0; tick < seconds * 67; tick++) {
            robot.tick();
            trail.accept(robot.state());
        }
    }

    private Element draw() throws Exception {
        byte[] svg = RoomDrawing.svg(robot.state(), trail).getBytes(StandardCharsets.UTF_8);
        return DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(svg))
                .getDocumentElement();
    }

    @Test
    void itIsAnSvgDocumentEvenOfARobotThatNeverMoved() throws Exception {
        assertThat(draw().getTagName()).isEqualTo("svg");
        seconds(1);
        Element svg = draw();
        assertThat(svg.getElementsByTagName("polygon").getLength())
                .as("the cliff and the dock")
                .isEqualTo(2);
        assertThat(svg.getTextContent())
                .contains("1 m")
                .doesNotContain("cleans")
                .doesNotContain("driven");
    }

    @Test
    void eachPieceOfTheWayHasItsCausesColor() throws Exception {
        send(new Command.Start(), new Command.Safe(), new DriveDirect(200, 200));
        seconds(3);
        send(new Command.Clean());
        seconds(5);
        send(new Command.Clean());
        seconds(1);
        robot.place(new Pose(-300, 900, 1));
        send(new Command.Spot());
        seconds(5);
        assertThat(trail.pieces())
                .extracting(Trail.Piece::cause)
                .containsExactly(Cause.CLIENT, Cause.CLEAN, Cause.SPOT);
        Trail.Piece driven = trail.pieces().get(0);
        Trail.Piece cleaning = trail.pieces().get(1);
        assertThat(driven.points().get(0).xMm()).isCloseTo(100, offset(1.0));
        assertThat(cleaning.points().get(0))
                .as("pieces join")
                .isEqualTo(driven.points().get(driven.points().size() - 1));
        assertThat(trail.pieces().get(2).points().get(0).yMm())
                .as("but not where the robot was carried")
                .isCloseTo(900, offset(1.0));
        Element svg = draw();
        NodeList lines = svg.getElementsByTagName("polyline");
        assertThat(lines.getLength()).isEqualTo(3);
        for (int i = 0; i < 3; i++) {
            assertThat(((Element) lines.item(i)).getAttribute("stroke"))
                    .isEqualTo(trail.pieces().get(i).cause().color());
        }
        assertThat(svg.getTextContent())
                .contains("driven by a program", "spot cleans")
                .doesNotContain("seeks");
    }

    @Test
    void theMarkerAndWhatACameraSeesAreDrawn() throws Exception {
        assertThat(draw().getElementsByTagName("polygon").getLength()).isEqualTo(2);
        robot.moveMarker(new Pose(900, 200, Math.PI));
        assertThat(draw().getElementsByTagName("polygon").getLength()).isEqualTo(3);
        String svg = RoomDrawing.svg(robot.state(), trail, 60);
        // The robot at 100, 200 looks along x; 4 m along the edges of 60 degrees.
        assertThat(svg).contains("class='sight' points='100,200 3564,-1800 ").contains(" 3564,2200'");
    }

    @Test
    void allOfTheWayIsWithinThePicture() throws Exception {
        send(new Command.Start(), new Command.Full(), new DriveDirect(400, 380));
        seconds(20);
        String[] box = draw().getAttribute("viewBox").split(" ", -1);
        double left = Double.parseDouble(box[0]);
        double top = Double.parseDouble(box[1]);
        for (Trail.Piece piece : trail.pieces()) {
            for (Point point : piece.points()) {
                assertThat(point.xMm()).isBetween(left, left + Double.parseDouble(box[2]));
                assertThat(-point.yMm()).isBetween(top, top + Double.parseDouble(box[3]));
            }
        }
    }
}
