package org.evoloop.roomba;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.List;
import java.util.function.Function;
import org.evoloop.journal.Journal;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * What can be chosen of a {@link RoombaConverter}.
 *
 * <p>Threading: immutable.
 */
public final class RoombaOptions {
    private final RobotModels models;
    private final Function<Clock, StartPointSensor> startPoint;
    private MoveOptions move = MoveOptions.defaults();
    private Duration spotWait = Duration.ofSeconds(5);
    private QuietHours quietHours = QuietHours.none();
    private List<Timetable> timetable = List.of();
    private @Nullable Journal journal;

    private RoombaOptions(RobotModels models, Function<Clock, StartPointSensor> startPoint) {
        this.models = models;
        this.startPoint = startPoint;
    }

    /**
     * A patient Move, five seconds for SpotWait, no quiet hours, no timetable and no journal.
     *
     * @param models the robot's, with the functions of their new states
     * @param startPoint opens what senses where Move has to go
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

    /** The same with another patience of Move. */
    public RoombaOptions withMove(MoveOptions other) {
        RoombaOptions copy = copy();
        copy.move = requireNonNull(other);
        return copy;
    }

    /** The same where SpotWait waits so long for a second press. */
    public RoombaOptions withSpotWait(Duration other) {
        RoombaOptions copy = copy();
        copy.spotWait = requireNonNull(other);
        return copy;
    }

    /** The same where the converter keeps what it is told; null if it keeps nothing. */
    public RoombaOptions withJournal(@Nullable Journal other) {
        RoombaOptions copy = copy();
        copy.journal = other;
        return copy;
    }

    /** The same with hours in which what the timetable begins has to wait. */
    RoombaOptions withQuietHours(QuietHours other) {
        RoombaOptions copy = copy();
        copy.quietHours = other;
        return copy;
    }

    /** The same with times at which the robot shall clean. */
    RoombaOptions withTimetable(List<Timetable> other) {
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

    List<Timetable> timetable() {
        return timetable;
    }

    @Nullable
    Journal journal() {
        return journal;
    }
}
