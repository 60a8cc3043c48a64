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
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.evoloop.JavaProcess;
import org.jspecify.annotations.Nullable;

/**
 * The lives of one converter, each a process of its own, and the device that outlives them, which is this process. It
 * executes every command written before the kill, like a device that reads from a serial line.
 */
final class Lives {
    private static final List<String> STATES = List.of("A", "B", "C");

    /** How often the device received each command, by the press and the state. */
    private final Map<String, Integer> reported = new TreeMap<>();

    private final Map<Integer, String> pressed = new TreeMap<>();
    private final Map<Integer, String> ended = new TreeMap<>();
    private final List<Integer> accepted = new ArrayList<>();
    private final List<String> doubts = new ArrayList<>();
    private final Random random;
    private final Path journal;
    private final Forcing forcing;
    private int device;
    private int presses;

    Lives(Path journal, Forcing forcing, long seed) {
        this.journal = journal;
        this.forcing = forcing;
        this.random = new Random(seed);
    }

    private Process begin() throws IOException {
        return new ProcessBuilder(JavaProcess.command(KilledConverter.class, journal.toString(), forcing.name()))
                .redirectError(
                        journal.resolveSibling(journal.getFileName() + ".log").toFile())
                .start();
    }

    /** One life, which a kill ends at a random moment of its start, its recovery or its work. */
    void liveAndBeKilled() throws Exception {
        Process process = begin();
        CountDownLatch started = new CountDownLatch(1);
        Thread reader = reading(process, started);
        try (PrintWriter controller = new PrintWriter(process.getOutputStream(), true, StandardCharsets.UTF_8)) {
            if (random.nextInt(4) > 0) {
                started.await(30, TimeUnit.SECONDS);
                press(controller, 1 + random.nextInt(8));
            }
            if (random.nextBoolean()) {
                int before = evolutions();
                controller.println("evolve");
                awaitEvolution(process, before);
                process.waitFor(random.nextInt(random.nextInt(3) == 0 ? 500_000 : 50_000), TimeUnit.MICROSECONDS);
            }
            process.waitFor(random.nextInt(25_000), TimeUnit.MICROSECONDS);
            press(controller, random.nextInt(3));
            process.waitFor(random.nextInt(5_000), TimeUnit.MICROSECONDS);
            // Unlike Process, its handle does not close the pipe from which the device still reads.
            process.toHandle().destroyForcibly();
            process.waitFor();
            awaitLastWords(reader);
        }
    }

    private synchronized int evolutions() {
        return evolutions;
    }

    /** Waits until the converter is about to evolve to other models, or has done so. */
    private synchronized void awaitEvolution(Process process, int before) throws InterruptedException {
        while (process.isAlive() && evolutions == before) {
            wait(50);
        }
    }

    /** Waits until all that a process wrote has been read; fails if a line was wrong. */
    private void awaitLastWords(Thread reader) throws InterruptedException {
        reader.join();
        AssertionError wrong = misheard;
        if (wrong != null) {
            throw wrong;
        }
    }

    private void press(PrintWriter controller, int times) {
        for (int left = times; left > 0; left--) {
            String event = random.nextBoolean() ? "next" : "skip";
            synchronized (this) {
                pressed.put(++presses, event);
            }
            controller.println("press " + event + " " + presses);
        }
    }

    private Thread reading(Process process, CountDownLatch started) {
        Thread thread = new Thread(() -> {
            PrintWriter replies = new PrintWriter(process.getOutputStream(), true, StandardCharsets.UTF_8);
            try (BufferedReader lines =
                    new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
                for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                    hear(line, replies, started);
                }
            } catch (IOException closed) {
                // The pipe of a process that has ended may close during a read.
            } catch (AssertionError e) {
                misheard = e;
                process.toHandle().destroyForcibly();
            } finally {
                started.countDown();
            }
        });
        thread.start();
        return thread;
    }

    private synchronized void hear(String line, PrintWriter replies, CountDownLatch started) {
        String[] words = line.split(" ", 4);
        switch (words[0]) {
            case "do" -> {
                reported.merge(words[2] + " in " + words[3], 1, Integer::sum);
                assertThat(words[3]).as("%s", line).isEqualTo(STATES.get(device));
                device = (device + 1) % STATES.size();
                replies.println("done " + words[1]);
            }
            case "where" -> replies.println("in " + STATES.get(device));
            case "evolving" -> {
                evolvingTo = words[2];
                evolutions++;
            }
            case "model" -> {
                assertThat(words[1])
                        .as("entirely one model or entirely the other")
                        .isIn(model, evolvingTo);
                evolved += words[1].equals(model) ? 0 : 1;
                model = words[1];
                evolvingTo = model;
            }
            case "accepted" -> accepted.add(Integer.parseInt(words[1]));
            case "ended" -> ended.put(Integer.parseInt(words[1]), words[2] + " " + (words.length > 3 ? words[3] : ""));
            case "doubt" -> {
                if (line.length() > "doubt ".length()) {
                    doubts.add(line);
                }
            }
            case "started" -> started.countDown();
            case "at" -> at = line;
            default -> {}
        }
        notifyAll();
    }

    private String at = "";

    // The converter's models, and those to which it may have evolved since it reported them.

    private String model = "new";
    private String evolvingTo = "new";
    private int evolutions;
    private int evolved;

    private volatile @Nullable AssertionError misheard;

    /** The last life, which ends when nothing waits. */
    void liveToTheEnd() throws Exception {
        Process process = begin();
        Thread reader = reading(process, new CountDownLatch(1));
        try (PrintWriter controller = new PrintWriter(process.getOutputStream(), true, StandardCharsets.UTF_8)) {
            controller.println("press next " + ++presses);
            synchronized (this) {
                pressed.put(presses, "next");
                long limit = System.nanoTime() + TimeUnit.MINUTES.toNanos(1);
                while (!ended.containsKey(presses) && process.isAlive() && System.nanoTime() < limit) {
                    wait(1_000);
                }
            }
            controller.println("status");
        }
        process.waitFor(60, TimeUnit.SECONDS);
        process.toHandle().destroyForcibly();
        awaitLastWords(reader);
        assertThat(process.exitValue()).as("the last life: %s", log()).isZero();
    }

    private String log() throws IOException {
        return Files.readString(journal.resolveSibling(journal.getFileName() + ".log"));
    }

    /** Checks the promises. */
    synchronized void check() {
        assertThat(reported.values()).as("no effect twice: %s", reported).containsOnly(1);
        assertThat(ended.keySet()).as("no accepted press is lost").containsAll(accepted);
        int inDoubt = 0;
        boolean failedBefore = false;
        for (Map.Entry<Integer, String> end : ended.entrySet()) {
            if (end.getKey() > 0) {
                failedBefore = hasFailed(end.getKey(), end.getValue(), failedBefore);
                inDoubt += failedBefore ? 1 : 0;
            }
        }
        assertThat(doubts).as("doubts are reported").hasSizeGreaterThanOrEqualTo(inDoubt > 0 ? 1 : 0);
        assertThat(doubts)
                .allMatch(doubt ->
                        doubt.startsWith("doubt it is unknown whether next had its effect: the converter's process"));
        assertThat(at).isEqualTo("at " + STATES.get(device) + " " + STATES.get(device) + " 0");
    }

    /**
     * Returns whether one of its steps was in doubt.
     *
     * @param ahead whether the previous press has failed, so that the device may be one step ahead of the new model
     */
    private boolean hasFailed(int press, String outcome, boolean ahead) {
        int steps = 0;
        for (String state : STATES) {
            steps += reported.getOrDefault(press + " in " + state, 0);
        }
        int planned = pressed.get(press).equals("skip") ? 2 : 1;
        if (outcome.startsWith("HANDLED")) {
            assertThat(steps)
                    .as("press %d of %s", press, pressed.get(press))
                    .isBetween(ahead ? planned - 1 : planned, planned);
            return false;
        }
        assertThat(outcome).as("press %d", press).isEqualTo("FAILED the converter's process ended meanwhile");
        assertThat(steps).isLessThanOrEqualTo(planned);
        return true;
    }

    @Override
    public synchronized String toString() {
        return accepted.size() + " presses accepted, " + reported.size() + " commands, " + doubts.size()
                + " in doubt, evolved " + evolved + " times";
    }
}
