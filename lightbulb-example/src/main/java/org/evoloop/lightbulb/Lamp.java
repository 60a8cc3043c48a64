package org.evoloop.lightbulb;

import org.evoloop.console.Console;

/** The device: its firmware knows nothing but {@code switch}. The filter in front of it is the converter's. */
final class Lamp {
    private static final boolean COLOURS = Console.isOnTerminal();

    private boolean on;
    private boolean filtered;
    private Bulbs bulbs = (daylight, warm) -> {};

    /** What gives its light, if it is more than a word on the screen. */
    interface Bulbs {
        void show(boolean daylight, boolean warm);
    }

    /** Has {@code real} give its light. */
    synchronized void shownBy(Bulbs real) {
        bulbs = real;
    }

    /** The one thing that the lamp itself can do. */
    synchronized void toggle() {
        on = !on;
        show();
    }

    /** Whether it is on, as a lamp remains while no converter runs. */
    synchronized void remains(boolean lit) {
        on = lit;
        bulbs.show(on && !filtered, on && filtered);
    }

    /** Puts a filter in front of the lamp, or takes it away. */
    synchronized void filter(boolean inPlace) {
        filtered = inPlace;
        show();
    }

    private void show() {
        bulbs.show(on && !filtered, on && filtered);
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
