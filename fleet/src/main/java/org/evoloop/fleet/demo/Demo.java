package org.evoloop.fleet.demo;

import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import org.evoloop.fleet.device.Model;
import org.evoloop.fleet.stream.Fleet;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.stream.FleetTopics;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.wire.ModelRecord;
import org.evoloop.fleet.wire.Rollout;
import org.evoloop.fleet.wire.Topic;

/**
 * A thousand lamps at a real broker, with presses, an instance that leaves, a poison record, models that take over by
 * share, and models that are bad.
 *
 * <p>Threading: for one thread.
 *
 * @since 0.1
 */
public final class Demo implements AutoCloseable {
    private static final int PARTITIONS = 4;
    private static final Duration LIMIT = Duration.ofSeconds(60);

    private final PrintWriter out;
    private final FleetSettings settings;
    private final KafkaCluster cluster;
    private final ModelRecord lamp;
    private final Edge edge;
    private final List<Fleet> instances = new ArrayList<>();
    private final Random random = new Random(1);
    private final int pressesPerSecond;
    private final List<String> problems = new ArrayList<>();
    private final long begunNanos = System.nanoTime();
    private int number;

    /**
     * Creates the topics.
     *
     * @param lamp the lamps' first models
     * @param directory the instances' state directory
     */
    public Demo(KafkaCluster cluster, String fleet, ModelRecord lamp, int devices, Path directory, PrintWriter out) {
        this.cluster = cluster;
        this.lamp = lamp;
        this.out = out;
        this.settings = FleetSettings.defaults()
                .withFleet(fleet)
                .withStateDirectory(directory)
                .withPatience(Duration.ofSeconds(5));
        this.pressesPerSecond = Math.max(20, devices / 5);
        try (FleetTopics topics = new FleetTopics(cluster, fleet)) {
            topics.create(PARTITIONS);
            topics.check();
        }
        Model compiled = ModelRecord.read("lamp-1", lamp.bytes());
        this.edge = new Edge(cluster, fleet, compiled.rules().table().models().original(), devices, Set.of("lamp-3"));
    }

    /** Runs the demo; returns the problems found. */
    public List<String> run() throws InterruptedException {
        edge.write(Topic.MODELS, "lamp-1", lamp.bytes());
        edge.write(Topic.MODELS, "lamp-2", lampWaiting(1_000).bytes());
        edge.write(Topic.MODELS, "lamp-3", lampWaiting(3_000).bytes());
        head();
        instances.add(instance());
        instances.add(instance());
        for (Fleet each : instances) {
            check(each.awaitRunning(LIMIT), "an instance of the fleet did not start");
        }
        row("two instances run");
        edge.register("lamp-1");
        await(() -> has("lamp-1") == edge.size());
        row(edge.size() + " lamps are registered");
        press(6, "their switches are pressed");
        edge.write(Topic.OCCURRENCES, "lamp-1", "{\"schema\":1,".getBytes(StandardCharsets.UTF_8));
        edge.write(
                Topic.OCCURRENCES,
                "lamp-none",
                "{\"schema\":1,\"atMillis\":0,\"event\":\"switch\"}".getBytes(StandardCharsets.UTF_8));
        await(() -> edge.counts().deadLetters == 2);
        check(edge.counts().deadLetters == 2, "not both bad records became dead letters");
        edge.deadLetters().forEach(letter -> row("dead letter for " + letter));
        instances.remove(0).close();
        press(4, "one instance has left");
        rollOut("lamp-2", 1);
        rollOut("lamp-2", 10);
        rollOut("lamp-2", 100);
        press(4, "all have lamp-2");
        rollOutWhatIsNoGood();
        settle();
        return problems;
    }

    private ModelRecord lampWaiting(long millis) {
        List<ModelRecord.Timer> timers = lamp.timers().stream()
                .map(timer -> new ModelRecord.Timer(timer.state(), timer.event(), millis))
                .toList();
        return new ModelRecord(lamp.file(), lamp.text(), lamp.original(), lamp.evolved(), timers, lamp.queueCapacity());
    }

    private Fleet instance() {
        number++;
        Path own = settings.stateDirectory().resolve("instance-" + number);
        Fleet fleet = new Fleet(cluster, settings.withStateDirectory(own));
        fleet.start();
        return fleet;
    }

    private void rollOut(String to, double percent) {
        edge.write(Topic.ROLLOUTS, "to-" + to, new Rollout("to-" + to, "lamp-1", to, percent, "", 5, 50, "").bytes());
        long wanted = Math.round(edge.size() * percent / 100);
        // Devices are selected by a hash, so the share is only approximate.
        await(() -> percent < 100 ? has(to) * 2L >= wanted && has(to) > 0 : has(to) == wanted);
        press(2, to + " takes over at " + Math.round(percent) + " %");
        check(percent < 100 || has(to) == wanted, to + " did not take over everywhere");
        check(edge.stopped().isEmpty(), "the rollout of " + to + " was stopped: " + edge.stopped());
    }

    private void rollOutWhatIsNoGood() {
        edge.write(
                Topic.ROLLOUTS, "to-lamp-3", new Rollout("to-lamp-3", "lamp-2", "lamp-3", 10, "", 5, 20, "").bytes());
        await(() -> has("lamp-3") * 20L > edge.size());
        row("lamp-3 takes over at 10 %; its lamps do not react");
        pressUntil(() -> !edge.stopped().isEmpty());
        check(!edge.stopped().isEmpty(), "a rollout in which every event fails was not stopped");
        row("stopped: " + edge.stopped());
        pressUntil(() -> has("lamp-3") == 0);
        check(has("lamp-3") == 0, "lamp-3 was not rolled back everywhere");
        row("lamp-2 is back everywhere");
    }

    /** Without further presses, waits until everything in progress has finished. */
    private void settle() {
        long[] seen = {-1};
        long[] since = {System.nanoTime()};
        await(() -> {
            if (seen[0] != edge.counts().decisions) {
                seen[0] = edge.counts().decisions;
                since[0] = System.nanoTime();
            }
            return edge.elsewhere() == 0
                    && System.nanoTime() - since[0] > Duration.ofSeconds(4).toNanos();
        });
        row("all is quiet");
        check(edge.repeated() == 0, edge.repeated() + " commands came twice");
        check(
                edge.sequences() == edge.counts().commands,
                "a command was lost: the lamps got " + edge.counts().commands + " of " + edge.sequences());
        check(edge.elsewhere() == 0, edge.elsewhere() + " lamps are in other states than the fleet shows");
        check(
                edge.counts().switches == edge.counts().pressed,
                "of " + edge.counts().pressed + " presses " + edge.counts().switches + " were decided");
        check(edge.early() == 0, edge.early() + " timers fired early");
    }

    private void check(boolean holds, String problem) {
        if (!holds) {
            problems.add(problem);
        }
    }

    private int has(String model) {
        return edge.byModel().getOrDefault(model, 0);
    }

    private void press(int seconds, String what) {
        long end = System.nanoTime() + Duration.ofSeconds(seconds).toNanos();
        pressUntil(() -> System.nanoTime() > end);
        row(what);
    }

    private void pressUntil(BooleanSupplier enough) {
        long begun = System.nanoTime();
        long pressed = 0;
        while (!enough.getAsBoolean() && System.nanoTime() - begun < LIMIT.toNanos()) {
            long due = (System.nanoTime() - begun) * pressesPerSecond / 1_000_000_000L;
            for (; pressed < due; pressed++) {
                edge.press(random.nextInt(edge.size()));
            }
            edge.poll(Duration.ofMillis(5));
        }
    }

    private void await(BooleanSupplier enough) {
        long begun = System.nanoTime();
        while (!enough.getAsBoolean() && System.nanoTime() - begun < LIMIT.toNanos()) {
            edge.poll(Duration.ofMillis(20));
        }
    }

    // The table

    private void head() {
        out.println("  time   pressed  commands  decided  failed  timers  dead   p50 ms  p99 ms  what happens");
        out.flush();
    }

    private void row(String what) {
        Edge.Counts counts = edge.counts();
        Map<String, Integer> models = edge.byModel();
        out.println(String.format(
                Locale.ROOT,
                "%5.1f s %9d %9d %8d %7d %7d %5d %8d %7d  %s%s",
                (System.nanoTime() - begunNanos) / 1e9,
                counts.pressed,
                counts.commands,
                counts.decisions,
                counts.failed,
                counts.timers,
                counts.deadLetters,
                edge.latencies().percentile(50),
                edge.latencies().percentile(99),
                what,
                models.isEmpty()
                        ? ""
                        : models.entrySet().stream()
                                .map(each -> each.getKey() + " " + each.getValue())
                                .collect(Collectors.joining(", ", " (", ")"))));
        out.flush();
        edge.latencies().clear();
    }

    @Override
    public void close() {
        instances.forEach(Fleet::close);
        edge.close();
    }
}
