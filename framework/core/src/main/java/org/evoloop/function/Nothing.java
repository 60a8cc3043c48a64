package org.evoloop.function;

/** The function of a state in which nothing has to run. */
final class Nothing implements NewFunction {
    static final Nothing INSTANCE = new Nothing();

    private Nothing() {}

    @Override
    public void run(Visit visit) {
        // The state waits for an event.
    }
}
