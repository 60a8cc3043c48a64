package org.evoloop.benchmarks.decision;

/** The libraries that are compared. */
public enum Library {
    EVOLOOP {
        @Override
        Walker walk(Walk walk) {
            return new EvoloopWalker(walk);
        }
    },
    STATELESS4J {
        @Override
        Walker walk(Walk walk) {
            return new Stateless4jWalker(walk);
        }
    },
    COLA {
        @Override
        Walker walk(Walk walk) {
            return new ColaWalker(walk);
        }
    },
    SQUIRREL {
        @Override
        Walker walk(Walk walk) {
            return new SquirrelWalker(walk);
        }
    },
    COMMONS_SCXML {
        @Override
        Walker walk(Walk walk) {
            return new ScxmlWalker(walk);
        }
    },
    SPRING {
        @Override
        Walker walk(Walk walk) {
            return new SpringWalker(walk);
        }
    },
    HASH_MAP {
        @Override
        Walker walk(Walk walk) {
            return new HashMapWalker(walk);
        }
    };

    /** A machine of this library, at the beginning of the way. */
    abstract Walker walk(Walk walk);
}
