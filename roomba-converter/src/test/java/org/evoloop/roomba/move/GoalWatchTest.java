package org.evoloop.roomba.move;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.evoloop.roomba.camera.CameraHealth;
import org.evoloop.roomba.camera.Look;
import org.evoloop.roomba.camera.Sighting;
import org.evoloop.roomba.move.phase.Ending;
import org.evoloop.roomba.move.phase.Sight;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.PacketGroup;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.OdometryPose;
import org.evoloop.roomba.session.Telemetry;
import org.junit.jupiter.api.Test;

class GoalWatchTest {
    private static final Sighting AHEAD = new Sighting(1_000, 0);

    private final GoalWatch watch = new GoalWatch(millis(300));
    private long frame;

    private static long millis(long count) {
        return count * 1_000_000;
    }

    private static Look look(long frame, long takenMillis, Sighting... seen) {
        return new Look(
                frame, millis(takenMillis), CameraHealth.SEEING, Stream.of(seen).findFirst());
    }

    private Telemetry telemetry(OdometryPose pose) {
        return new Telemetry(
                ++frame,
                SensorValues.of(
                        List.of(PacketGroup.values()), packet -> packet == Packet.OI_MODE ? OiMode.SAFE.code() : 0),
                pose);
    }

    private Sight at(long nowMillis, OdometryPose pose, Look look) {
        return watch.update(new Percept(millis(nowMillis), telemetry(pose), look, Ending.NONE, true));
    }

    private Sight at(long nowMillis, Look look) {
        return at(nowMillis, OdometryPose.ORIGIN, look);
    }

    @Test
    void believesTheThirdLookInARowThatShowsTheSamePlace() {
        assertThat(at(10, look(1, 0, AHEAD)).goal()).isEmpty();
        assertThat(at(40, look(2, 30, AHEAD)).goal()).isEmpty();
        assertThat(at(55, look(2, 30, AHEAD)).goal()).as("the same look again").isEmpty();
        Sight third = at(70, look(3, 60, AHEAD));
        assertThat(third.goal()).contains(new OdometryPose(1_000, 0, 0));
        assertThat(third.goalNanos()).isEqualTo(millis(60));
    }

    @Test
    void startsAgainAfterALookThatShowsNothingOrAnotherPlace() {
        at(10, look(1, 0, AHEAD));
        at(40, look(2, 30, AHEAD));
        at(70, look(3, 60));
        at(100, look(4, 90, AHEAD));
        at(130, look(5, 120, AHEAD));
        assertThat(at(160, look(6, 150, new Sighting(1_300, 0))).goal()).isEmpty();
    }

    @Test
    void aPlaceThatIsBelievedFollowsEachLookThatAgrees() {
        at(10, look(1, 0, AHEAD));
        at(40, look(2, 30, AHEAD));
        at(70, look(3, 60, AHEAD));
        at(100, look(4, 90));
        assertThat(at(130, look(5, 120, new Sighting(1_020, 0))).goal()).contains(new OdometryPose(1_020, 0, 0));
        assertThat(at(160, look(6, 150, new Sighting(500, 0))).goal()).contains(new OdometryPose(1_020, 0, 0));
    }

    @Test
    void aLookCountsFromWhereTheRobotWasWhenItWasTaken() {
        at(0, new OdometryPose(0, 0, 0), look(0, 0));
        for (int count = 1; count <= 3; count++) {
            at(
                    100 * count,
                    new OdometryPose(100 * count, 0, 0),
                    look(count, 100 * (count - 1), new Sighting(1_100 - 100 * count, 0)));
        }
        Sight sight = at(310, new OdometryPose(310, 0, 0), look(3, 200));
        assertThat(sight.goal().orElseThrow().xMm()).isCloseTo(1_000, within(1e-9));
    }

    @Test
    void isStaleBeforeTheFirstFrameAndWhenNoneCameForTooLong() {
        assertThat(at(0, look(0, 0)).stale()).isTrue();
        assertThat(at(300, look(1, 0)).stale()).isFalse();
        assertThat(at(301, look(1, 0)).stale()).isTrue();
    }
}
