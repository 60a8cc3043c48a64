package org.evoloop.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.fleet.stream.Fleet;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.wire.Topic;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Dead letters are sent again once their cause was removed. */
class ResendTest {
    private static final String PRESS = "{\"schema\":1,\"number\":%d,\"atMillis\":%d,\"event\":\"switch\"%s}";

    @TempDir
    private Path directory;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private String run(Cluster cluster, String... words) throws Exception {
        List<String> all = new ArrayList<>(List.of("fleet"));
        all.addAll(List.of(words));
        all.addAll(List.of("--bootstrap", Brokers.shared(), "--name", cluster.fleet()));
        out.getBuffer().setLength(0);
        int status =
                CommandLines.run(new PrintWriter(out, true), new PrintWriter(err, true), all.toArray(String[]::new));
        assertThat(status).as(err.toString()).isZero();
        return out.toString();
    }

    @Test
    void eachIsSentOnceAndComesBackIfItsCauseRemains() throws Exception {
        try (Cluster cluster = Cluster.fresh(2);
                Fleet fleet = fleet(cluster)) {
            fleet.start();
            assertThat(fleet.awaitRunning(Duration.ofMinutes(1))).isTrue();
            assertThat(run(cluster, "resend")).isEqualTo("there are no dead letters to send again\n");
            press(cluster, "early", 1, "");
            press(cluster, "early", 2, "");
            press(cluster, "never\t", 1, "");
            cluster.write(Topic.OCCURRENCES, "early", "nonsense".getBytes(StandardCharsets.UTF_8));
            press(cluster, "early", 3, ",\"values\":{\"text\":\"" + "x".repeat(600_000) + "\"}");
            cluster.readUntil(all -> all.of(Topic.DEAD_LETTERS).size() == 5);

            assertThat(run(cluster, "resend", "--list").lines())
                    .hasSize(4)
                    .anyMatch(line ->
                            line.startsWith("unknown-device\t" + cluster.fleet() + ".occurrences\tnever \tno device"));
            String lamp = Path.of(System.getProperty("evoloop.root", ".."), "models", "light-bulb.xml")
                    .toString();
            run(cluster, "publish", "lamp-1", lamp);
            run(cluster, "register", "--model", "lamp-1", "early");
            cluster.readUntil(all -> !all.of(Topic.STATES, "early").isEmpty());
            assertThat(run(cluster, "resend")).isEqualTo("unknown-device: 3 sent again\n");
            assertThat(err.toString()).contains("1 were too large to be kept whole");
            cluster.readUntil(all -> !all.of(Topic.COMMANDS, "early").isEmpty()
                    && all.of(Topic.DEAD_LETTERS, "never\t").size() == 2);

            // Only what came back.
            assertThat(run(cluster, "resend", "--reason", "unknown-model,malformed"))
                    .isEqualTo("malformed: 1 sent again\n");
            assertThat(run(cluster, "resend")).isEqualTo("unknown-device: 1 sent again\n");
            cluster.readUntil(all -> all.of(Topic.DEAD_LETTERS, "never\t").size() == 3);
            assertThat(run(cluster, "resend", "--list").lines()).hasSize(1);
        }
    }

    @Test
    void anUnknownReasonIsRefused() throws Exception {
        int status = CommandLines.run(
                new PrintWriter(out, true),
                new PrintWriter(err, true),
                "fleet",
                "resend",
                "--bootstrap",
                Brokers.shared(),
                "--reason",
                "bad");
        assertThat(status).isEqualTo(2);
        assertThat(err.toString()).startsWith("error: --reason is 'bad', allowed are malformed, newer-schema");
    }

    private Fleet fleet(Cluster cluster) throws Exception {
        FleetSettings settings =
                FleetSettings.defaults().withFleet(cluster.fleet()).withStateDirectory(directory);
        return new Fleet(KafkaCluster.at(Brokers.shared()), settings);
    }

    private static void press(Cluster cluster, String device, int number, String more) {
        String record = String.format(PRESS, number, System.currentTimeMillis(), more);
        cluster.write(Topic.OCCURRENCES, device, record.getBytes(StandardCharsets.UTF_8));
    }
}
