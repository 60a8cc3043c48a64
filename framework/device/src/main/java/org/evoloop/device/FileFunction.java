package org.evoloop.device;

import java.time.Duration;
import java.time.LocalTime;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.evolution.Values;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A function of a device file. It never waits on its own thread, so that it runs in a converter without threads, too.
 *
 * <p>Threading: immutable; {@link #run} as {@link NewFunction}.
 *
 * @param steps done one after another when the state is entered
 * @param period how often {@code repeated} is done; null for never
 * @param repeated done again and again while the state lasts
 * @param daily what is done at times of day
 * @param onExit done when the state is left
 */
record FileFunction(
        List<Action> steps,
        @Nullable Duration period,
        List<Action> repeated,
        Map<LocalTime, List<Action>> daily,
        List<Action.Do> onExit)
        implements NewFunction {
    private static final Logger LOG = LoggerFactory.getLogger(FileFunction.class);

    FileFunction {
        steps = List.copyOf(steps);
        repeated = List.copyOf(repeated);
        daily = Map.copyOf(daily);
        onExit = List.copyOf(onExit);
    }

    /** The events that it may send to the device. */
    Set<String> sends() {
        return Stream.of(
                        steps.stream(),
                        repeated.stream(),
                        daily.values().stream().flatMap(List::stream))
                .flatMap(each -> each)
                .filter(Action.Send.class::isInstance)
                .map(each -> ((Action.Send) each).event())
                .collect(Collectors.toSet());
    }

    @Override
    public void run(Visit visit) {
        if (!onExit.isEmpty()) {
            visit.onEnd(this::leave);
        }
        daily.forEach((time, actions) -> visit.daily(time, () -> perform(actions, visit)));
        if (period != null) {
            visit.after(period, () -> repeat(period, visit));
        }
        perform(steps, visit);
    }

    private void repeat(Duration every, Visit visit) {
        // First, so that it is repeated even if it fails.
        visit.after(every, () -> repeat(every, visit));
        perform(repeated, visit);
    }

    /** Performs all actions, those after a wait later. The first that fails is the last. */
    private static void perform(List<Action> actions, Visit visit) {
        for (int next = 0; next < actions.size(); next++) {
            Action action = actions.get(next);
            if (action instanceof Action.Wait wait) {
                List<Action> rest = actions.subList(next + 1, actions.size());
                visit.after(wait.time(), () -> perform(rest, visit));
                return;
            }
            try {
                perform(action, visit);
            } catch (InterruptedException left) {
                Thread.currentThread().interrupt();
                return;
            } catch (Exception failure) {
                visit.failed(
                        action instanceof Action.Do outside
                                ? outside.what() + ": " + failure.getMessage()
                                : String.valueOf(failure.getMessage()));
                return;
            }
        }
    }

    private static void perform(Action action, Visit visit) throws Exception {
        if (action instanceof Action.Send send) {
            visit.send(send.event());
        } else if (action instanceof Action.Raise raise) {
            visit.raise(raise.event());
        } else if (action instanceof Action.Finish finish) {
            visit.finish(finish.event());
        } else if (action instanceof Action.Say say) {
            visit.say(say.text());
        } else if (action instanceof Action.Do outside) {
            outside.perform(Values.NONE, visit::say);
        }
    }

    private void leave() {
        for (Action.Do action : onExit) {
            try {
                action.perform(Values.NONE, what -> LOG.debug("{}", what));
            } catch (InterruptedException stop) {
                Thread.currentThread().interrupt();
                return;
            } catch (Exception failure) {
                LOG.warn("{}, when a state was left: {}", action.what(), failure.getMessage());
            }
        }
    }
}
