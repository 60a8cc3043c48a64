package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.LongFunction;
import java.util.stream.LongStream;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.simulator.eye.Effects;
import org.evoloop.roomba.simulator.room.Marker;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.RandomRooms;
import org.evoloop.roomba.simulator.room.Room;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Move in random rooms, from rendered pictures through OpenCV to the wheels. Each seed is a room and a start. */
class MoveExperimentTest {
    private static final double FARTHEST_MISS_MM = 50;
    private static final double FARTHEST_MISS_DEG = 3;
    private static final double FASTEST_TOUCH_MM_PER_S = 100;

    private enum End {
        ARRIVED,
        GAVE_UP,
        FALSE_ARRIVAL
    }

    /** The result for one room. */
    private record Run(long seed, End end, double seconds, double touchMmPerS) {}

    private static Run run(long seed, Room room, Effects effects, Duration limit) {
        Pose marker = room.marker().map(Marker::pose).orElse(null);
        try (MoveTrip trip = new MoveTrip(
                room,
                marker,
                MoveTrip.withTimeout(),
                MoveOptions.defaults().withLimit(limit),
                (robot, clock) -> new RenderedCamera(robot, room, clock, effects, seed))) {
            long began = trip.truth().timeMillis();
            trip.ends(limit.plusSeconds(5));
            boolean spot = trip.stepped.states().evolved().name().equals("Spot");
            boolean there = marker != null && trip.missMm() < FARTHEST_MISS_MM && trip.missDeg() < FARTHEST_MISS_DEG;
            assertThat(spot || trip.stepped.states().evolved().name().equals("On"))
                    .as("seed %d: Move has ended, in %s", seed, trip.stepped.states())
                    .isTrue();
            return new Run(
                    seed,
                    spot ? there ? End.ARRIVED : End.FALSE_ARRIVAL : End.GAVE_UP,
                    (trip.truth().timeMillis() - began) / 1000.0,
                    trip.fastestTouchMmPerS());
        }
    }

    private static void assertRuns(
            String name, int rooms, LongFunction<Room> room, Effects effects, Duration limit, double leastShare) {
        List<Run> runs = LongStream.rangeClosed(1, rooms)
                .parallel()
                .mapToObj(seed -> run(seed, room.apply(seed), effects, limit))
                .toList();
        long arrived = runs.stream().filter(run -> run.end() == End.ARRIVED).count();
        List<Double> seconds = runs.stream()
                .filter(run -> run.end() == End.ARRIVED)
                .map(Run::seconds)
                .sorted()
                .toList();
        System.out.printf(
                Locale.ROOT,
                "%s: seeds 1 to %d, %d arrived, median %.0f s, fastest touch %.1f mm/s, gave up: %s%n",
                name,
                rooms,
                arrived,
                Optional.of(seconds)
                        .filter(some -> !some.isEmpty())
                        .map(some -> some.get(some.size() / 2))
                        .orElse(0.0),
                runs.stream().mapToDouble(Run::touchMmPerS).max().orElseThrow(),
                runs.stream()
                        .filter(run -> run.end() == End.GAVE_UP)
                        .map(Run::seed)
                        .toList());
        assertThat(runs).as(name).noneMatch(run -> run.end() == End.FALSE_ARRIVAL);
        assertThat(runs).as(name).allMatch(run -> run.touchMmPerS() <= FASTEST_TOUCH_MM_PER_S);
        assertThat((double) arrived / rooms).as(name).isGreaterThanOrEqualTo(leastShare);
    }

    @Test
    void arrivesInAFewRooms() {
        assertRuns(
                "a few rooms",
                2,
                seed -> RandomRooms.withMarker(seed, 500, 2_000),
                Effects.TYPICAL,
                Duration.ofMinutes(5),
                0.5);
    }

    @Test
    @Tag("slow")
    void arrivesInMostOf200Rooms() {
        assertRuns("typical", 200, RandomRooms::withMarker, Effects.TYPICAL, Duration.ofMinutes(10), 0.98);
    }

    @Test
    @Tag("slow")
    void arrivesFromTwoMetersInTheHardSetting() {
        assertRuns(
                "hard, 2 m",
                100,
                seed -> RandomRooms.withMarker(seed, 1_900, 2_100),
                Effects.HARD,
                Duration.ofMinutes(10),
                0.9);
    }

    @Test
    @Tag("slow")
    void arrivesNowhereInAThousandRoomsWithoutAMarker() {
        assertRuns("no marker", 1_000, RandomRooms::withoutMarker, Effects.TYPICAL, Duration.ofSeconds(20), 0);
    }
}
