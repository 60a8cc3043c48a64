package org.evoloop.learn;

import java.time.Duration;
import java.time.LocalTime;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.evoloop.learn.Heard.Reply;
import org.evoloop.learn.LearnedDevice.DisturbedException;
import org.evoloop.learn.LearnedDevice.LostException;
import org.evoloop.time.Clock;

/** Takes one word after another to the device, within the rules and the budget. */
final class Session {
    /** How often a word is begun again because somebody else acted, or the device was gone. */
    private static final int MOST_DISTURBED = 20;

    private static final int MOST_LOST = 3;

    /** How often the device is begun to be brought home at the end. */
    private static final int MOST_LEFT = 3;

    private static final Duration HOUR = Duration.ofHours(1);
    private static final Duration A_LOOK = Duration.ofMinutes(1);

    private final LearnedDevice device;
    private final LearnRules rules;
    private final LearnSettings settings;
    private final Clock clock;
    private final long begin;
    /** When the presses of the last hour were. */
    private final Deque<Long> pressed = new ArrayDeque<>();

    private int words;
    /** How many events a reset has sent at most, so that a word is only begun if it can be ended. */
    private int resetSize;

    Session(LearnedDevice device, LearnRules rules, LearnSettings settings, Clock clock) {
        this.device = device;
        this.rules = rules;
        this.settings = settings;
        this.clock = clock;
        this.begin = clock.nanoTime();
    }

    /** What a word was answered. */
    record Answer(String atReset, List<Step> steps) {}

    /** How many words the device was given. */
    int words() {
        return words;
    }

    Duration elapsed() {
        return Duration.ofNanos(clock.nanoTime() - begin);
    }

    /**
     * Resets the device and gives it {@code inputs}.
     *
     * @throws OpenEndException if the budget is spent, a rule ends learning, or the device cannot be used
     */
    Answer ask(List<String> inputs) throws InterruptedException {
        int disturbed = 0;
        int lost = 0;
        while (true) {
            untilAllowed((int) inputs.stream()
                    .filter(input -> !input.equals(LearnedDevice.WAIT))
                    .count());
            try {
                return once(inputs);
            } catch (DisturbedException other) {
                disturbed++;
                if (disturbed == MOST_DISTURBED) {
                    throw new OpenEndException("the device is never left alone: " + other.getMessage());
                }
            } catch (LostException gone) {
                lost++;
                if (lost == MOST_LOST) {
                    throw new OpenEndException(String.valueOf(gone.getMessage()));
                }
            }
        }
    }

    private Answer once(List<String> inputs) throws InterruptedException {
        words++;
        int before = device.sent();
        String atReset = counted(device::reset).shown();
        resetSize = Math.max(resetSize, device.sent() - before);
        String shown = atReset;
        List<Step> steps = new ArrayList<>();
        for (String input : inputs) {
            if (Thread.interrupted()) {
                throw new InterruptedException();
            }
            requireHarmless();
            Heard heard;
            if (input.equals(LearnedDevice.WAIT)) {
                heard = device.await(settings.longest());
            } else if (rules.forbid(input, shown)) {
                heard = new Heard(Reply.FORBIDDEN, List.of(), shown, Duration.ZERO);
            } else {
                heard = counted(() -> device.press(input));
            }
            steps.add(new Step(input, heard));
            shown = heard.shown();
        }
        requireHarmless();
        return new Answer(atReset, steps);
    }

    /**
     * Leaves the device where every word begins, unless it was not touched.
     *
     * @return why it could not be left there; empty if it is there
     */
    String leave() {
        if (device.sent() == 0) {
            return "";
        }
        boolean stopped = Thread.interrupted();
        String why = "";
        try {
            for (int attempt = 0; attempt < MOST_LEFT; attempt++) {
                try {
                    device.reset();
                    return "";
                } catch (DisturbedException person) {
                    why = String.valueOf(person.getMessage());
                } catch (InterruptedException again) {
                    // Whoever is impatient wants it at home, too.
                    stopped = true;
                    why = "stopped while it was brought there";
                }
            }
        } catch (LostException lost) {
            why = String.valueOf(lost.getMessage());
        } finally {
            if (stopped) {
                Thread.currentThread().interrupt();
            }
        }
        return "the device may not be at home: " + why;
    }

    private interface Sending {
        Heard send() throws InterruptedException;
    }

    /** Notes when something was sent, even if it came to nothing. */
    private Heard counted(Sending sending) throws InterruptedException {
        int before = device.sent();
        try {
            return sending.send();
        } finally {
            for (int i = before; i < device.sent(); i++) {
                pressed.addLast(clock.nanoTime());
            }
        }
    }

    private void requireHarmless() {
        String reason = rules.stopAt(device.readings()).orElse("");
        if (!reason.isEmpty()) {
            throw new OpenEndException("a rule of the file ended it: " + reason);
        }
    }

    /** Waits until the rules allow so many presses in a row. */
    private void untilAllowed(int presses) throws InterruptedException {
        if (presses + resetSize > rules.pressesAnHour()) {
            throw new OpenEndException(
                    "a rule allows " + rules.pressesAnHour() + " presses an hour, and the next word has " + presses);
        }
        while (true) {
            if (elapsed().compareTo(settings.budget()) >= 0) {
                throw new OpenEndException("the budget is spent");
            }
            while (!pressed.isEmpty() && clock.nanoTime() - pressed.getFirst() >= HOUR.toNanos()) {
                pressed.removeFirst();
            }
            boolean few = pressed.size() + presses + resetSize <= rules.pressesAnHour();
            LearnRules.Hours hours = rules.hours();
            if (few && (hours == null || hours.contain(LocalTime.ofInstant(clock.wallTime(), hours.zone())))) {
                return;
            }
            clock.sleep(A_LOOK);
        }
    }
}
