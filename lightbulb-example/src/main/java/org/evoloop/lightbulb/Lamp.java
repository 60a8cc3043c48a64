package org.evoloop.lightbulb;

import org.evoloop.console.Console;

/** The device: its firmware knows nothing but {@code switch}. The filter in front of it is the converter's. */
final class Lamp {
    private static final boolean COLOURS = Console.isOnTerminal();

    private boolean on;
    private boolean filtered;

    /** The one thing that the lamp itself can do. */
    synchronized void toggle() {
        on = !on;
        System.out.println(this);
    }

    /** Whether it is on, as a lamp remains while no converter runs. */
    synchronized void remains(boolean lit) {
        on = lit;
    }

    /** Puts a filter in front of the lamp, or takes it away. */
    synchronized void filter(boolean inPlace) {
        filtered = inPlace;
        System.out.println(this);
    }

    /** What is to be seen. */
    @Override
    public synchronized String toString() {
        String light = !on ? "( ) dark" : filtered ? "(*) incandescent" : "(*) daylight";
        String colour = !on ? "90" : filtered ? "38;5;214" : "97";
        return COLOURS ? "\033[" + colour + "m" + light + "\033[0m" : light;
    }
}
