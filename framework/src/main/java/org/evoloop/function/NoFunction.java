package org.evoloop.function;

/** The function of a state in which nothing has to run; it needs no thread. */
enum NoFunction implements NewFunction {
    INSTANCE;

    @Override
    public void run(Visit visit) {}
}
