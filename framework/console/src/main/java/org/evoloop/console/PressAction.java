package org.evoloop.console;

import java.io.PrintStream;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.function.Function;
import org.evoloop.converter.PushMonitor;
import org.evoloop.evolution.EventOutcome;

/**
 * Operates a control of the controller. Who gives the command may wait for the outcome.
 *
 * @param controller whose control it is
 * @param event the event that the arguments name
 */
record PressAction(PushMonitor controller, Function<List<String>, String> event) implements ConsoleCommand.Action {
    /** Waits for the outcome. */
    static final String WAIT = "--wait";

    private static final String NO_WAIT = "--no-wait";

    /** The second line of the help. */
    static final String HELP =
            "--wait waits for the outcome, and fails unless that is 'handled'; ctl waits unless --no-wait is given";

    /** The arguments without these options. */
    static List<String> named(List<String> arguments) {
        return arguments.stream()
                .filter(word -> !word.equals(WAIT) && !word.equals(NO_WAIT))
                .toList();
    }

    @Override
    public void run(List<String> arguments, PrintStream out) throws InterruptedException, ExecutionException {
        run(arguments, out, false);
    }

    /**
     * Operates the control.
     *
     * @param waiting whether to wait for the outcome if the arguments do not say
     * @throws IllegalStateException if the event is lost, or its outcome, if that was waited for, is another than {@code
     *     handled}
     */
    void run(List<String> arguments, PrintStream out, boolean waiting) throws InterruptedException, ExecutionException {
        String pressed = event.apply(named(arguments));
        if (!arguments.contains(WAIT) && (!waiting || arguments.contains(NO_WAIT))) {
            controller.press(pressed);
            return;
        }
        EventOutcome outcome = controller.submit(pressed).get();
        if (!outcome.isHandled()) {
            throw new IllegalStateException(outcome.toString());
        }
        out.println(outcome);
    }
}
