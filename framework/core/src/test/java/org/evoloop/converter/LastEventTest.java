package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.evoloop.evolution.Occurrence;
import org.evoloop.loop.Failure;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A function that ends with an event for which its state has no transition has failed, and everybody is told. */
@Timeout(60)
class LastEventTest {

    @Test
    void isToldAtOnce() throws InterruptedException {
        try (LiveRobot robot = new LiveRobot(visit -> visit.finish("arriveSpt"))) {
            List<String> told = new CopyOnWriteArrayList<>();
            robot.converter.addListener(new ConverterListener() {
                @Override
                public void failed(Failure<Occurrence> failure) {
                    told.add(failure.component() + ": " + failure.cause().getMessage());
                }
            });
            robot.press("Clean", "Spot");

            String why = "Move has no transition for arriveSpt, with which its function ends; did you mean arriveSpot?";
            LiveRobot.until(() -> told.contains("Move: " + why));
            assertThat(robot.converter.status().faults()).singleElement().satisfies(fault -> {
                assertThat(fault.part()).isEqualTo("function Move");
                assertThat(fault.lastFailure()).contains(why);
            });
            assertThat(robot.states()).isEqualTo(Robot.at("On", "Move"));
        }
    }
}
