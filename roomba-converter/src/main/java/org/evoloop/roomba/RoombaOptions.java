package org.evoloop.roomba;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.List;
import java.util.function.Function;
import org.evoloop.function.QuietHours;
import org.evoloop.journal.Journal;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.time.Clock;
import org.evoloop.time.TimeOfWeek;
import org.jspecify.annotations.Nullable;

/**
 * The options of a {@link RoombaConverter}.
 *
 * <p>Threading: immutable, but for the quiet hours, which their owner may change.
 */
public final class RoombaOptions {
    private final RobotModels models;
    private final Function<Clock, StartPointSensor> startPoint;
    private MoveOptions move = MoveOptions.defaults();
    private Duration spotWait = Duration.ofSeconds(5);
    private QuietHours quietHours = QuietHours.none();
    private List<TimeOfWeek> timetable = List.of();
    private @Nullable Journal journal;

    private RoombaOptions(RobotModels models, Function<Clock, StartPointSensor> startPoint) {
        this.models = models;
        this.startPoint = startPoint;
    }

    /**
     * Default limits for Move, five seconds for SpotWait, no quiet hours, no timetable and no journal.
     *
     * @param models the robot's models, with the functions of their new states
     * @param startPoint opens the sensor of Move's target
     */
    public static RoombaOptions of(RobotModels models, Function<Clock, StartPointSensor> startPoint) {
        return new RoombaOptions(requireNonNull(models), requireNonNull(startPoint));
    }

    private RoombaOptions copy() {
        RoombaOptions copy = new RoombaOptions(models, startPoint);
        copy.move = move;
        copy.spotWait = spotWait;
        copy.quietHours = quietHours;
        copy.timetable = timetable;
        copy.journal = journal;
        return copy;
    }

    /** A copy with other options of Move. */
    public RoombaOptions withMove(MoveOptions other) {
        RoombaOptions copy = copy();
        copy.move = requireNonNull(other);
        return copy;
    }

    /** A copy with another time that SpotWait waits for a second press. */
    public RoombaOptions withSpotWait(Duration other) {
        RoombaOptions copy = copy();
        copy.spotWait = requireNonNull(other);
        return copy;
    }

    /** A copy with a journal; null for none. */
    public RoombaOptions withJournal(@Nullable Journal other) {
        RoombaOptions copy = copy();
        copy.journal = other;
        return copy;
    }

    /** A copy with quiet hours; the timetable's events wait until they end. */
    RoombaOptions withQuietHours(QuietHours other) {
        RoombaOptions copy = copy();
        copy.quietHours = other;
        return copy;
    }

    /** A copy with times at which the robot must clean. */
    RoombaOptions withTimetable(List<TimeOfWeek> other) {
        RoombaOptions copy = copy();
        copy.timetable = List.copyOf(other);
        return copy;
    }

    RobotModels models() {
        return models;
    }

    Function<Clock, StartPointSensor> startPoint() {
        return startPoint;
    }

    MoveOptions move() {
        return move;
    }

    Duration spotWait() {
        return spotWait;
    }

    QuietHours quietHours() {
        return quietHours;
    }

    List<TimeOfWeek> timetable() {
        return timetable;
    }

    @Nullable
    Journal journal() {
        return journal;
    }
}
