package org.evoloop.lightbulb;

import org.evoloop.console.Console;

/** The device. Its firmware knows only {@code switch}; the filter in front of it belongs to the converter. */
final class Lamp {
    private static final boolean COLOURS = Console.isOnTerminal();

    private boolean on;
    private boolean filtered;
    private Bulbs bulbs = (daylight, warm) -> {};

    /** Real lamps that show the light, in addition to the text on the screen. */
    interface Bulbs {
        void show(boolean daylight, boolean warm);
    }

    /** Connects real lamps. */
    synchronized void shownBy(Bulbs real) {
        bulbs = real;
    }

    /** Switches the lamp: the only thing that its firmware can do. */
    synchronized void toggle() {
        on = !on;
        show();
    }

    /** Sets the state in which the lamp was left while no converter was running. */
    synchronized void remains(boolean lit) {
        on = lit;
        bulbs.show(on && !filtered, on && filtered);
    }

    /** Moves the filter in front of the lamp, or away from it. */
    synchronized void filter(boolean inPlace) {
        filtered = inPlace;
        show();
    }

    private void show() {
        bulbs.show(on && !filtered, on && filtered);
        System.out.println(this);
    }

    /** What a person sees. */
    @Override
    public synchronized String toString() {
        String light = !on ? "( ) dark" : filtered ? "(*) incandescent" : "(*) daylight";
        String colour = !on ? "90" : filtered ? "38;5;214" : "97";
        return COLOURS ? "\033[" + colour + "m" + light + "\033[0m" : light;
    }
}
