package org.evoloop.benchmarks.decision;

/** The libraries compared. */
public enum Library {
    EVOLOOP("Evoloop") {
        @Override
        Walker walk(Walk walk) {
            return new EvoloopWalker(walk);
        }
    },
    STATELESS4J("stateless4j") {
        @Override
        Walker walk(Walk walk) {
            return new Stateless4jWalker(walk);
        }
    },
    COLA("COLA") {
        @Override
        Walker walk(Walk walk) {
            return new ColaWalker(walk);
        }
    },
    SQUIRREL("squirrel") {
        @Override
        Walker walk(Walk walk) {
            return new SquirrelWalker(walk);
        }
    },
    COMMONS_SCXML("Commons SCXML") {
        @Override
        Walker walk(Walk walk) {
            return new ScxmlWalker(walk);
        }
    },
    SPRING("Spring") {
        @Override
        Walker walk(Walk walk) {
            return new SpringWalker(walk);
        }
    },
    HASH_MAP("map of maps") {
        @Override
        Walker walk(Walk walk) {
            return new HashMapWalker(walk);
        }
    };

    private final String label;

    Library(String label) {
        this.label = label;
    }

    /** The name in the table. */
    String label() {
        return label;
    }

    /** A machine of this library, in the walk's initial state. */
    abstract Walker walk(Walk walk);

    /** The number of events between two readings of the processor time, for a fast library. */
    static final int QUICK_LAP = 1 << 14;

    /**
     * The number of events between two readings of the processor time: high enough to make their cost negligible, low
     * enough to take little time.
     */
    int lap() {
        return switch (this) {
            case SPRING -> 4;
            case SQUIRREL, COMMONS_SCXML -> 1 << 10;
            default -> QUICK_LAP;
        };
    }
}
