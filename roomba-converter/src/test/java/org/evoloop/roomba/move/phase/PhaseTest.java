package org.evoloop.roomba.move.phase;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.roomba.move.phase.Given.MEMORY;
import static org.evoloop.roomba.move.phase.Given.NOTHING;
import static org.evoloop.roomba.move.phase.Given.at;
import static org.evoloop.roomba.move.phase.Given.seeing;
import static org.evoloop.roomba.move.phase.Given.touching;

import java.util.Optional;
import org.evoloop.roomba.move.phase.Situation.Obstacle;
import org.evoloop.roomba.session.OdometryPose;
import org.junit.jupiter.api.Test;

class PhaseTest {
    private static final Phase APPROACH = new Approach(MEMORY);

    private static Phase.Step next(Phase phase, Situation now) {
        return Phase.inAny(phase, now);
    }

    @Test
    void stopsWhileTheNewestLookIsStaleAndContinuesWithTheSamePhase() {
        assertThat(next(APPROACH, seeing(at(NOTHING, 1_000, 2, 301), 2_000, 0)))
                .isEqualTo(new Phase.Step(APPROACH, Maneuver.STAND));
        assertThat(next(APPROACH, seeing(at(NOTHING, 1_000, 2, 299), 2_000, 0)).maneuver())
                .isEqualTo(Maneuver.towards(1_600, 0));
    }

    @Test
    void looksOnlyAtWhatWasTakenAfterItStood() {
        Phase look = Look.around(MEMORY, NOTHING);
        assertThat(look).isInstanceOf(Turn.class);
        Phase standing = next(look, NOTHING).phase();
        assertThat(standing).isInstanceOf(Look.class);
        assertThat(next(standing, seeing(at(NOTHING, 200, 2, 0), 2_000, 0)).phase())
                .isInstanceOf(Look.class);
        assertThat(next(standing, seeing(at(NOTHING, 251, 3, 0), 2_000, 0)).phase())
                .isInstanceOf(Approach.class);
    }

    @Test
    void turnsOnAfterThreeCalmLooksInVain() {
        Phase phase = new Look(MEMORY, 0, 0, Calm.after(MEMORY, NOTHING));
        for (int frame = 2; frame <= 3; frame++) {
            phase = next(phase, at(NOTHING, 250 + 30 * frame, frame, 0)).phase();
            assertThat(phase).isInstanceOf(Look.class);
        }
        Phase turn = next(phase, at(NOTHING, 350, 4, 0)).phase();
        assertThat(turn).isInstanceOf(Turn.class);
        assertThat(((Turn) turn).headingRad()).isEqualTo(-Look.STEP_RAD);
    }

    @Test
    void aGoalThatWasNotSeenForLongIsLookedForAgain() {
        Situation seen = seeing(at(NOTHING, 1_000, 2, 0), 2_000, 0);
        assertThat(next(APPROACH, at(seen, 1_600, 20, 0)).phase()).isEqualTo(APPROACH);
        Phase.Step lost = next(APPROACH, at(seen, 1_601, 20, 0));
        assertThat(lost.phase()).isInstanceOf(Turn.class);
        assertThat(lost.maneuver()).isEqualTo(Maneuver.STAND);
    }

    @Test
    void anObstacleEndsWhatLeadsForwardAndACliffAlsoATurn() {
        Situation now = seeing(NOTHING, 2_000, 0);
        Phase back = next(APPROACH, touching(now, Obstacle.LEFT, false)).phase();
        assertThat(back).isInstanceOf(Leg.class);
        assertThat(((Leg) back).lengthMm()).isNegative();
        Phase away = ((Leg) back).then();
        assertThat(((Turn) away).headingRad()).as("away to the right").isNegative();

        Turn turn = Turn.exactly(MEMORY, 1, APPROACH);
        assertThat(next(turn, touching(now, Obstacle.LEFT, false)).phase()).isEqualTo(turn);
        assertThat(next(turn, touching(now, Obstacle.LEFT, true)).phase()).isInstanceOf(Leg.class);
        assertThat(next(back, touching(now, Obstacle.LEFT, true)).phase()).isEqualTo(back);
    }

    @Test
    void hasArrivedOnlyWhenCalmLooksShowItAsNearAndAsStraightAheadAsWanted() {
        assertThat(judged(400, 0)).isInstanceOf(Maneuver.Arrive.class);
        assertThat(judged(418, 0)).isInstanceOf(Maneuver.Arrive.class);
        assertThat(judged(425, 0)).isEqualTo(Maneuver.STAND);
        assertThat(judged(375, 0)).isEqualTo(Maneuver.STAND);
        assertThat(judged(400, 12)).isEqualTo(Maneuver.STAND);
    }

    private static Maneuver judged(double xMm, double yMm) {
        Phase phase = Check.begin(MEMORY, NOTHING);
        Maneuver maneuver = Maneuver.STAND;
        for (int frame = 2; frame <= 4; frame++) {
            assertThat(maneuver).isEqualTo(Maneuver.STAND);
            Phase.Step step = next(phase, seeing(at(NOTHING, 300 + 30 * frame, frame, 0), xMm, yMm));
            phase = step.phase();
            maneuver = step.maneuver();
        }
        return maneuver;
    }

    @Test
    void aTurnTakesTheShortestWay() {
        Turn turn = Turn.exactly(MEMORY, Math.toRadians(350), APPROACH);
        assertThat(next(turn, NOTHING).maneuver()).isEqualTo(Maneuver.turn(Math.toRadians(-10)));
    }

    @Test
    void wandersAwayFromWhereItLookedInVainAndFromWhatWasInTheWay() {
        Memory wiser = MEMORY.withStation(new OdometryPose(0, 0, 0)).withObstacle(new OdometryPose(400, 0, 0));
        Phase turn = Wandering.on(wiser, OdometryPose.ORIGIN, Optional.of(new OdometryPose(900, -900, 0)));
        assertThat(Math.toDegrees(((Turn) turn).headingRad())).isBetween(270.0, 359.0);
    }
}
