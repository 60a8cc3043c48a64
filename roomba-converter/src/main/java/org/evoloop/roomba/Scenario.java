package org.evoloop.roomba;

import java.util.Locale;

/** The scenarios of the demo. Each ends when the robot's true state shows its result. */
enum Scenario {
    /**
     * The paper's first listing: the robot's own buttons; the robot moves to the starting point before it spot cleans.
     */
    REMOTE_START {
        @Override
        void play(Play play) throws InterruptedException, Play.Unfulfilled {
            play.robotButton(RobotEvents.CLEAN).states("On", "On").robotIs("on", "safe");
            play.robotButton(RobotEvents.SPOT).states("Spot", "Spot").robotIs("spot", "passive");
            play.robotIsNear(START_X_MM, START_Y_MM, 600);
            play.states("On", "On").robotIs("on", "safe");
            play.robotIsNear(START_X_MM, START_Y_MM, 100);
        }
    },

    /** The paper's second listing: an external controller's buttons lead from cleaning to spot cleaning. */
    SPOT_FROM_CLEAN {
        @Override
        void play(Play play) throws InterruptedException, Play.Unfulfilled {
            startCleaning(play);
            play.controllerButton(RobotEvents.CLEAN).states("Clean", "SpotWait").robotIs("clean", "passive");
            play.controllerButton(RobotEvents.CLEAN).states("Spot", "Spot").robotIs("spot", "passive");
        }
    },

    /** The robot's own CLEAN button while it cleans: it pauses by itself, and spot cleans after a second press. */
    OWN_BUTTON {
        @Override
        void play(Play play) throws InterruptedException, Play.Unfulfilled {
            startCleaning(play);
            play.robotButton(RobotEvents.CLEAN).states("On", "SpotWait").robotIs("on", "safe");
            play.robotButton(RobotEvents.CLEAN).states("Spot", "Spot").robotIs("spot", "passive");
        }
    },

    /** No second press: the robot stops cleaning. */
    TIMEOUT {
        @Override
        void play(Play play) throws InterruptedException, Play.Unfulfilled {
            startCleaning(play);
            play.controllerButton(RobotEvents.CLEAN).states("Clean", "SpotWait");
            play.states("On", "On").robotIs("on", "safe");
        }
    },

    /** While the robot moves to the starting point, it evolves to spot clean once more; then that is rolled back. */
    EVOLVE {
        @Override
        void play(Play play) throws InterruptedException, Play.Unfulfilled {
            play.controllerButton(RobotEvents.CLEAN).states("On", "On").robotIs("on", "safe");
            play.controllerButton(RobotEvents.SPOT).states("On", "Move");
            play.evolve("models/cleaning-robot-twice.scxml").states("On", "Move");
            play.states("Spot", "Spot").robotIs("spot", "passive");
            play.states("On", "Again").robotIs("on", "safe");
            play.controllerButton(RobotEvents.CLEAN).states("Spot", "Spot").robotIs("spot", "passive");
            play.states("On", "Again").states("On", "On").robotIs("on", "safe");
            play.rollBack();
            play.controllerButton(RobotEvents.SPOT).states("Spot", "Spot").robotIs("spot", "passive");
            play.states("On", "On").robotIs("on", "safe");
        }
    };

    static final double START_X_MM = 1000;
    static final double START_Y_MM = 500;

    abstract void play(Play play) throws InterruptedException, Play.Unfulfilled;

    private static void startCleaning(Play play) throws InterruptedException, Play.Unfulfilled {
        play.controllerButton(RobotEvents.CLEAN).states("On", "On").robotIs("on", "safe");
        play.controllerButton(RobotEvents.CLEAN).states("Clean", "Clean").robotIs("clean", "passive");
    }

    /** Its name on the command line: {@code remote-start}. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The scenario of this name. */
    static Scenario of(String name) {
        for (Scenario scenario : values()) {
            if (scenario.toString().equals(name)) {
                return scenario;
            }
        }
        throw new IllegalArgumentException("there is no scenario " + name + "; there are "
                + String.join(
                        ", ",
                        java.util.Arrays.stream(values())
                                .map(Scenario::toString)
                                .toList()));
    }
}
