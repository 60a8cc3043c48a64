package org.evoloop.benchmarks.device;

import java.io.IOException;
import java.time.Duration;
import java.util.function.IntFunction;
import org.evoloop.benchmarks.running.PaperModels;
import org.evoloop.evolution.ModelPair;
import org.evoloop.journal.Journal;
import org.evoloop.link.Link;
import org.evoloop.loop.LoopConfig;
import org.evoloop.roomba.RobotModels;
import org.evoloop.roomba.RoombaConverter;
import org.evoloop.roomba.RoombaOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.roomba.session.SessionOptions;
import org.jspecify.annotations.Nullable;

/** The Roomba converter. Both of its models are the device's own, so that nothing else adds to the latency. */
final class ConverterAnswerer implements Answerer {
    private final RoombaConverter roomba;

    /** @param cable opens a link to the robot at a baud rate */
    ConverterAnswerer(IntFunction<Link> cable, LoopConfig config, @Nullable Journal journal)
            throws IOException, InterruptedException {
        var device = PaperModels.cleaningRobot().original();
        this.roomba = RoombaConverter.connect(
                cable,
                config,
                SessionOptions.defaults().withSilenceLimit(Duration.ofSeconds(8)),
                RoombaOptions.of(
                                RobotModels.of(new ModelPair(device, device)),
                                time -> StartPointSensor.byWheels(1000, 500))
                        .withJournal(journal));
        roomba.converter().start();
    }

    @Override
    public long answered() {
        return roomba.converter().status().events().handled();
    }

    @Override
    public void close() {
        roomba.close();
    }
}
