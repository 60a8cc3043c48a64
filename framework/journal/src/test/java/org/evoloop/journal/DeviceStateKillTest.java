package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import org.evoloop.JavaProcess;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Whenever the process is killed, the next one ends with the device where the new model's state needs it, and a press
 * that was interrupted ends in the state that it asked for, if it got the device there. Nothing is sent twice, nor
 * anything that nobody asked for. The device is this process, which outlives the others.
 */
class DeviceStateKillTest {
    @TempDir
    private Path directory;

    private final long seed = new Random().nextLong();
    private final Random random = new Random(seed);
    private final List<String> story = new ArrayList<>();
    private ModelPair models = Appliance.SHUTTER.models();
    private DecisionTable table = table(Appliance.SHUTTER);
    private State device = models.original().initial();

    /** What the last press was decided to be when it was made; null if there has been none, or the device has acted. */
    private Decision asked;

    /** What the device has received of it. */
    private final List<String> sent = new ArrayList<>();

    private int presses;
    private int lastEnded;
    private int pressed;
    private String at = "";
    private String wrong = "";
    private boolean started;

    @Test
    void someKills() throws Exception {
        kill(Appliance.SHUTTER, 4);
    }

    @ParameterizedTest
    @EnumSource(Appliance.class)
    @Tag("slow")
    void manyKills(Appliance appliance) throws Exception {
        kill(appliance, 100);
    }

    private static DecisionTable table(Appliance appliance) {
        ModelPair models = appliance.models();
        Set<Event> sendable = appliance.sendable().stream().map(Event::new).collect(Collectors.toSet());
        return DecisionTable.compile(
                models, new DeviceEvents(sendable, models.original().spontaneous()));
    }

    private void kill(Appliance appliance, int times) throws Exception {
        models = appliance.models();
        table = table(appliance);
        device = models.original().initial();
        int completed = 0;
        for (int life = 0; life <= times; life++) {
            try {
                completed += live(appliance, life < times) ? 1 : 0;
            } catch (AssertionError | InterruptedException failed) {
                throw new AssertionError(
                        "seed " + seed + ", life " + life + ":\n"
                                + String.join("\n", story.subList(Math.max(0, story.size() - 40), story.size())),
                        failed);
            }
        }
        System.out.printf("%d kills of %s, seed %d: %d presses were carried out%n", times, appliance, seed, completed);
        assertThat(times < 100 || completed > 0).isTrue();
    }

    /**
     * One life, which a kill ends at a random moment of its work.
     *
     * @return whether the press that the previous one interrupted has been carried out
     */
    private boolean live(Appliance appliance, boolean killed) throws Exception {
        Path journal = directory.resolve(appliance.name());
        begin();
        Process process = new ProcessBuilder(
                        JavaProcess.command(KilledAppliance.class, journal.toString(), appliance.name()))
                .redirectError(directory.resolve("log").toFile())
                .start();
        Thread reader = new Thread(() -> read(process));
        reader.start();
        try (PrintWriter controller = new PrintWriter(process.getOutputStream(), true, StandardCharsets.UTF_8)) {
            await(() -> started, process);
            Configuration now = settle(controller, process);
            boolean completed = isCarriedOut(now);
            if (act(controller)) {
                now = settle(controller, process);
            }
            press(controller, now);
            if (killed) {
                process.waitFor(random.nextInt(20_000), TimeUnit.MICROSECONDS);
                process.toHandle().destroyForcibly();
            } else {
                assertThat(isCarriedOut(settle(controller, process))).isTrue();
            }
            return completed;
        } finally {
            process.toHandle().destroyForcibly();
            process.waitFor();
            reader.join();
            assertThat(wrong).isEmpty();
        }
    }

    private synchronized void begin() {
        story.add("begins, the device in " + device);
        started = false;
        pressed = 0;
    }

    /** Waits until the record agrees with the device, and nothing is left to do. */
    private Configuration settle(PrintWriter controller, Process process) throws Exception {
        long limit = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
        while (true) {
            synchronized (this) {
                at = "";
            }
            controller.println("status");
            await(() -> !at.isEmpty(), process);
            synchronized (this) {
                assertThat(wrong).isEmpty();
                String[] now = at.split(" ");
                boolean rests = now[3].equals("0") && now[4].equals("true") && lastEnded >= pressed;
                if (now[1].equals(device.name()) && rests && isWhereNeeded(new State(now[2]))) {
                    story.add("settles: " + at);
                    return new Configuration(device, new State(now[2]));
                }
                assertThat(System.nanoTime())
                        .as("settled in time: %s, the device in %s", at, device)
                        .isLessThan(limit);
            }
        }
    }

    private boolean isWhereNeeded(State evolved) {
        return models.whereDeviceMustBe(evolved).contains(device);
    }

    /** Whether the last press has ended in the state that it asked for: always if the device has received all of it. */
    private synchronized boolean isCarriedOut(Configuration now) {
        if (asked == null) {
            return false;
        }
        boolean carriedOut = asked.after().equals(now);
        boolean isLost = asked.steps().isEmpty();
        assertThat(carriedOut || isLost || sent.size() < asked.steps().size())
                .as("%s has got the device there, but ends in %s", asked, now)
                .isTrue();
        return carriedOut;
    }

    private synchronized void press(PrintWriter controller, Configuration now) {
        List<Event> events = models.evolved().triggers().stream()
                .filter(event -> !models.original().spontaneous().contains(event)
                        && models.evolved().hasTrigger(now.evolved(), event))
                .toList();
        Event event = events.get(random.nextInt(events.size()));
        pressed = ++presses;
        asked = table.decide(now, event, false);
        sent.clear();
        story.add("press " + event + " " + presses + ": " + asked);
        controller.println("press " + event + " " + presses);
    }

    /** Perhaps the device does something by itself; returns whether it does. */
    private synchronized boolean act(PrintWriter controller) {
        for (Transition own : models.original().transitionsFrom(device)) {
            if (models.original().spontaneous().contains(own.event()) && random.nextInt(3) == 0) {
                device = own.target();
                asked = null;
                story.add("the device does " + own.event() + ", now in " + device);
                controller.println("act " + own.event());
                return true;
            }
        }
        return false;
    }

    private synchronized void await(BooleanSupplier condition, Process process) throws Exception {
        long limit = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
        while (!condition.getAsBoolean()) {
            assertThat(process.isAlive() && System.nanoTime() < limit)
                    .as("the converter lives: %s", Files.readString(directory.resolve("log")))
                    .isTrue();
            wait(20);
        }
    }

    private void read(Process process) {
        PrintWriter replies = new PrintWriter(process.getOutputStream(), true, StandardCharsets.UTF_8);
        try (BufferedReader lines =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                hear(line, replies);
            }
        } catch (IOException closed) {
            // The pipe of a process that has ended may close during a read.
        }
    }

    private synchronized void hear(String line, PrintWriter replies) {
        String[] words = line.split(" ");
        switch (words[0]) {
            case "greet" -> replies.println("found " + device);
            case "started" -> started = true;
            case "at" -> at = line;
            case "ended" -> lastEnded = Math.max(lastEnded, Integer.parseInt(words[1]));
            case "where" -> replies.println("in " + device);
            case "do" -> receive(words[1], Integer.parseInt(words[2]), replies);
            default -> {}
        }
        notifyAll();
    }

    private void receive(String event, int press, PrintWriter replies) {
        story.add("the device gets " + event + " of press " + press + " in " + device);
        sent.add(event);
        List<String> path = asked == null
                ? List.of()
                : asked.steps().stream().map(step -> step.trigger().name()).toList();
        boolean isNext =
                sent.size() <= path.size() && path.subList(0, sent.size()).equals(sent);
        if (press != presses || !isNext) {
            wrong = "nobody asked for " + event + " of press " + press + " in " + device + "; sent are " + sent;
        }
        device = models.original()
                .transition(device, new Event(event))
                .map(Transition::target)
                .orElse(device);
        replies.println("done " + device);
    }
}
