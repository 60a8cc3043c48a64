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
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.evoloop.JavaProcess;
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
 * Whenever the process is killed, the device is where the new model's state needs it once the next one has started,
 * nothing is sent twice, and nothing that nobody asked for. The device is this process, which outlives the others.
 */
class DeviceStateKillTest {
    @TempDir
    private Path directory;

    private final Random random = new Random();
    /** What the device received, by the press and its state then. */
    private final Map<String, Integer> received = new HashMap<>();

    private final List<String> story = new ArrayList<>();
    private ModelPair models = Appliance.SHUTTER.models();
    private State device = models.original().initial();
    private int presses;
    /** The last press of this life; 0 if there is none yet. */
    private int pressed;

    private int lastEnded;
    private String at = "";
    private String wrong = "";
    private boolean started;

    @Test
    void someKills() throws Exception {
        kill(Appliance.SHUTTER, 3);
    }

    @ParameterizedTest
    @EnumSource(Appliance.class)
    @Tag("slow")
    void manyKills(Appliance appliance) throws Exception {
        kill(appliance, 100);
    }

    private void kill(Appliance appliance, int times) throws Exception {
        models = appliance.models();
        device = models.original().initial();
        int inNewState = 0;
        for (int life = 0; life <= times; life++) {
            try {
                inNewState += live(appliance, life < times) ? 1 : 0;
            } catch (AssertionError | InterruptedException failed) {
                throw new AssertionError("life " + life + ": " + String.join("\n", story), failed);
            }
        }
        assertThat(times < 100 || inNewState > 0)
                .as("some lives begin in the new state")
                .isTrue();
    }

    /**
     * One life, which a kill ends at a random moment of its work.
     *
     * @return whether it began in the new state
     */
    private boolean live(Appliance appliance, boolean killed) throws Exception {
        Path journal = directory.resolve(appliance.name());
        tell("begins, the device in " + device, false);
        Process process = new ProcessBuilder(
                        JavaProcess.command(KilledAppliance.class, journal.toString(), appliance.name()))
                .redirectError(directory.resolve("log").toFile())
                .start();
        Thread reader = new Thread(() -> read(process));
        reader.start();
        try (PrintWriter controller = new PrintWriter(process.getOutputStream(), true, StandardCharsets.UTF_8)) {
            await(() -> started, process);
            boolean inNewState = settle(controller, process).equals(appliance.newState());
            act(controller);
            settle(controller, process);
            press(controller);
            if (killed) {
                process.waitFor(random.nextInt(20_000), TimeUnit.MICROSECONDS);
                process.toHandle().destroyForcibly();
            } else {
                settle(controller, process);
            }
            return inNewState;
        } finally {
            if (!killed) {
                process.waitFor(60, TimeUnit.SECONDS);
            }
            process.toHandle().destroyForcibly();
            process.waitFor();
            reader.join();
            tell("", false);
            assertThat(wrong).isEmpty();
        }
    }

    /**
     * Waits until the record agrees with the device, nothing is left to do, and the device is where the new model's
     * state needs it.
     *
     * @return the state of the new model
     */
    private String settle(PrintWriter controller, Process process) throws Exception {
        long limit = System.nanoTime() + TimeUnit.SECONDS.toNanos(30);
        while (true) {
            tell("", started);
            controller.println("status");
            await(() -> !at.isEmpty(), process);
            synchronized (this) {
                String[] now = at.split(" ");
                State evolved = new State(now[2]);
                boolean agrees = now[1].equals(device.name())
                        && models.whereDeviceMustBe(evolved).contains(device);
                boolean rests = now[3].equals("0") && now[4].equals("true") && lastEnded >= pressed;
                assertThat(wrong).isEmpty();
                if (agrees && rests) {
                    return evolved.name();
                }
                assertThat(System.nanoTime())
                        .as("settled in time: %s, the device in %s", at, device)
                        .isLessThan(limit);
            }
        }
    }

    private synchronized void press(PrintWriter controller) {
        List<Event> events = models.evolved().triggers().stream()
                .filter(event -> !models.original().spontaneous().contains(event))
                .toList();
        String event = random.nextBoolean() ? "extra" : events.get(random.nextInt(events.size())).name();
        pressed = ++presses;
        story.add("press " + event + " " + presses);
        controller.println("press " + event + " " + presses);
    }

    /** Perhaps the device does something by itself. */
    private synchronized void act(PrintWriter controller) {
        for (Transition own : models.original().transitionsFrom(device)) {
            if (models.original().spontaneous().contains(own.event()) && random.nextInt(3) == 0) {
                device = own.target();
                story.add("the device does " + own.event() + ", now in " + device);
                controller.println("act " + own.event());
                return;
            }
        }
    }

    private synchronized void tell(String what, boolean isStarted) {
        started = isStarted;
        pressed = isStarted ? pressed : 0;
        at = "";
        if (!what.isEmpty()) {
            story.add(what);
        }
        notifyAll();
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
            case "started" -> started = true;
            case "at" -> at = line;
            case "ended" -> lastEnded = Math.max(lastEnded, Integer.parseInt(words[1]));
            case "where" -> replies.println("in " + device);
            case "do" -> {
                story.add("the device gets " + words[1] + " of press " + words[2] + " in " + device);
                int times = received.merge(words[2] + " in " + device, 1, Integer::sum);
                wrong = times > 1 || words[2].equals("0") ? "sent twice, or for nobody: " + line : wrong;
                device = models.original()
                        .transition(device, new Event(words[1]))
                        .map(Transition::target)
                        .orElse(device);
                replies.println("done " + device);
            }
            default -> {}
        }
        notifyAll();
    }
}
