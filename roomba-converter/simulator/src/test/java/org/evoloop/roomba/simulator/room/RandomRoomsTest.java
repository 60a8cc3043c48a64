package org.evoloop.roomba.simulator.room;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.HashSet;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class RandomRoomsTest {
    private static final int ROOMS = 60;

    @Test
    void aSeedIsARoom() {
        for (long seed = 0; seed < 10; seed++) {
            Room one = RandomRooms.withMarker(seed);
            Room again = RandomRooms.withMarker(seed);
            assertThat(again.shapes()).isEqualTo(one.shapes());
            assertThat(again.start()).isEqualTo(one.start());
            assertThat(again.marker()).isEqualTo(one.marker());
            assertThat(RandomRooms.withMarker(seed + 1).start()).isNotEqualTo(one.start());
        }
    }

    @Test
    void aRobotCanComeToRestBeforeTheMarkerAndSeesItThere() {
        for (long seed = 0; seed < ROOMS; seed++) {
            Room room = RandomRooms.withMarker(seed);
            Marker marker = room.marker().orElseThrow();
            Pose goal = marker.before(RandomRooms.GOAL_MM);
            assertThat(room.isFree(goal)).as("seed %d", seed).isTrue();
            assertThat(room.freeMm(goal, 0)).as("seed %d", seed).isGreaterThan(RandomRooms.GOAL_MM - 1.1);
            assertThat(room.start().distanceMmTo(marker.pose().center()))
                    .as("seed %d", seed)
                    .isBetween(500.0, 3_500.0);
            assertThat(room.shapes()).as("seed %d", seed).hasSizeBetween(4, 9);
        }
    }

    @Test
    void theMarkerIsSeenFromTheStart() {
        for (long seed = 0; seed < ROOMS; seed++) {
            Room room = RandomRooms.withMarker(seed);
            Marker marker = room.marker().orElseThrow();
            Pose start = room.start();
            assertThat(Math.toDegrees(marker.pose().bearingRadTo(start.xMm(), start.yMm())))
                    .as("seed %d", seed)
                    .isBetween(-50.0, 50.0);
            for (double aside : new double[] {-marker.boardMm() / 2, 0, marker.boardMm() / 2}) {
                Point seen = marker.pose().ahead(1, aside);
                assertThat(room.freeMm(start, start.bearingRadTo(seen.xMm(), seen.yMm())))
                        .as("seed %d, %s mm aside", seed, aside)
                        .isGreaterThanOrEqualTo(start.distanceMmTo(seen));
            }
        }
    }

    @Test
    void roomsAreOfManyKinds() {
        Set<OptionalInt> colors = new HashSet<>();
        int behind = 0;
        int onStands = 0;
        for (long seed = 0; seed < ROOMS; seed++) {
            Room room = RandomRooms.withMarker(seed);
            Pose place = room.marker().orElseThrow().pose();
            double bearingRad = room.start().bearingRadTo(place.xMm(), place.yMm());
            colors.addAll(
                    room.shapes().stream().map(shape -> shape.finish().rgb()).collect(Collectors.toSet()));
            behind += Math.abs(bearingRad) > Math.PI / 2 ? 1 : 0;
            onStands += room.freeMm(place, Math.PI) > 10 ? 1 : 0;
        }
        assertThat(colors).hasSizeGreaterThan(8);
        assertThat(behind).isBetween(ROOMS / 4, ROOMS * 3 / 4);
        assertThat(onStands).isBetween(ROOMS / 10, ROOMS * 9 / 10);
    }

    @Test
    void theDistanceCanBeChosen() {
        for (long seed = 0; seed < 20; seed++) {
            Room room = RandomRooms.withMarker(seed, 1_900, 2_100);
            Point place = room.marker().orElseThrow().pose().center();
            assertThat(room.start().distanceMmTo(place)).as("seed %d", seed).isBetween(1_900.0, 2_100.0);
        }
        assertThatThrownBy(() -> RandomRooms.withMarker(1, 400, 500))
                .hasMessage("the marker is 400.0 to 500.0 mm away; allowed is 500.0 to 3500.0");
    }

    @Test
    void thereAreRoomsWithoutAMarker() {
        for (long seed = 0; seed < 10; seed++) {
            assertThat(RandomRooms.withoutMarker(seed).marker()).isEmpty();
            assertThat(RandomRooms.withoutMarker(seed).shapes().size()).isGreaterThan(1);
        }
    }
}
