package org.evoloop.roomba;

import java.time.Duration;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import org.evoloop.converter.Evolution;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.payload.JsonRecord;
import org.evoloop.payload.Part;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.Clock;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.ModelFiles;

/**
 * Plays a scenario with a converter and a simulated robot: presses buttons and waits for the required results, in the
 * converter's states and in the robot's true state.
 *
 * <p>Threading: used by one thread.
 */
final class Play {
    private static final Duration LOOK = Duration.ofMillis(20);
    private static final Duration RELEASE = Duration.ofMillis(50);
    private static final Duration PATIENCE = Duration.ofMinutes(2);

    /** A required result of a scenario did not occur. */
    static final class Unfulfilled extends Exception {
        Unfulfilled(String message) {
            super(message);
        }
    }

    private final RoombaConverter roomba;
    private final SimulatedWorld world;
    private final Clock clock;

    Play(RoombaConverter roomba, SimulatedWorld world, Clock clock) {
        this.roomba = roomba;
        this.world = world;
        this.clock = clock;
    }

    /** Presses a button on the robot after all buttons are released. */
    Play robotButton(String event) throws InterruptedException, Unfulfilled {
        await(
                "the robot's buttons to be released",
                () -> JsonRecord.of(world.execute("state")).texts("pressed").isEmpty());
        // The next press comes late enough for one frame to show the release.
        clock.sleep(RELEASE);
        String answer = world.execute("press " + event.toLowerCase(Locale.ROOT));
        if (!answer.equals("ok")) {
            throw new IllegalStateException("the simulator answered: " + answer);
        }
        return this;
    }

    /** Presses a button of the external controller. */
    Play controllerButton(String event) {
        roomba.controller().press(event);
        return this;
    }

    /** Evolves to another new model while the robot keeps running. */
    Play evolve(String models) {
        StateMachine evolved =
                ModelFile.read(ModelFiles.find(models, Play.class)).only();
        ModelPair next = new ModelPair(roomba.models().pair().original(), evolved);
        roomba.converter().evolve(Evolution.to(roomba.converter().knowledgeOf(next)));
        return this;
    }

    /** Restores the previous models. */
    Play rollBack() {
        roomba.converter().rollBack();
        return this;
    }

    /** Waits until both models are in these states. */
    Play states(String original, String evolved) throws InterruptedException, Unfulfilled {
        Configuration wanted = new Configuration(new State(original), new State(evolved));
        await("the states " + wanted, () -> configuration().equals(wanted));
        return this;
    }

    /** Waits until the robot's true activity is {@code activity}, in OI mode {@code mode}. */
    Play robotIs(String activity, String mode) throws InterruptedException, Unfulfilled {
        await(
                "the robot in activity " + activity + " and mode " + mode,
                () -> truth("activity").equals(activity) && truth("oiMode").equals(mode));
        return this;
    }

    /** Checks that the robot's true position is within {@code toleranceMm} of a point. */
    void robotIsNear(double xMm, double yMm, double toleranceMm) throws Unfulfilled {
        double away = Math.hypot(Double.parseDouble(truth("xMm")) - xMm, Double.parseDouble(truth("yMm")) - yMm);
        if (away > toleranceMm) {
            throw new Unfulfilled(
                    String.format(Locale.ROOT, "the robot is %.0f mm away from (%.0f, %.0f) mm", away, xMm, yMm));
        }
    }

    private void await(String what, BooleanSupplier holds) throws InterruptedException, Unfulfilled {
        long deadline = clock.nanoTime() + PATIENCE.toNanos();
        while (!holds.getAsBoolean()) {
            if (clock.nanoTime() > deadline) {
                throw new Unfulfilled("waited " + PATIENCE.toSeconds() + " s for " + what + ", but the states are "
                        + configuration() + " and the robot is " + world.execute("state"));
            }
            clock.sleep(LOOK);
        }
    }

    private Configuration configuration() {
        return roomba.converter().status().states();
    }

    /** A value of the robot's true state. */
    private String truth(String key) {
        return Part.at("/" + key).in(world.execute("state")).orElse("");
    }
}
