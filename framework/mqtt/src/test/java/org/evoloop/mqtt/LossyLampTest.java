package org.evoloop.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.Random;
import org.evoloop.Machines;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.imitation.Faults;
import org.evoloop.imitation.Imitation;
import org.evoloop.loop.LoopConfig;
import org.evoloop.payload.Meanings;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A lamp behind a gateway that loses one command in twenty, and obeys and reports late, sometimes too late, at a real
 * broker. Its own log is the truth: the converter's record is never wrong without a doubt.
 */
class LossyLampTest {
    private static final Duration PATIENCE = Duration.ofSeconds(60);
    private static final Duration LIMIT = Duration.ofMillis(400);
    private static final StateMachine MODEL = Machines.machine("lamp", "off toggle -> on", "on toggle -> off");
    private static final Meanings STATES = Meanings.at("/state", Map.of("on", "on", "off", "off"));

    @TempDir
    private Path directory;

    @Test
    void aFewPresses() throws Exception {
        Faults many =
                new Faults(20, 10, 20, LIMIT.dividedBy(2), LIMIT.multipliedBy(6).dividedBy(5));
        press(40, many, 7);
    }

    @Test
    @Tag("slow")
    void aThousandPresses() throws Exception {
        press(1000, Faults.around(LIMIT), Long.getLong("evoloop.seed", new Random().nextLong()));
    }

    private void press(int presses, Faults faults, long seed) throws Exception {
        try (Mosquitto broker = new Mosquitto(directory).start();
                Imitation lamp = new Imitation(MODEL, faults, seed);
                Gateway gateway = new Gateway(broker.port(), "z2m/lamp", lamp);
                SystemClock clock = new SystemClock();
                BrokerConnection connection = new BrokerConnection(BrokerAddress.parse(broker.url()), "converter");
                SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock))) {
            PushMonitor wall = new PushMonitor("Wall");
            assemble(converter, connection, clock, wall);
            connection.open();
            await().atMost(PATIENCE).until(connection::isUp);
            int doubts = 0;
            for (int press = 1; press <= presses; press++) {
                wall.submit("toggle").join();
                doubts += converter.status().doubt().isEmpty() ? 0 : 1;
                await().pollInterval(Duration.ofMillis(2))
                        .atMost(PATIENCE)
                        .until(() -> converter.status().doubt().isEmpty());
                ConverterStatus status = converter.status();
                assertThat(status.states().original().name())
                        .as("seed %d, press %d, the lamp %s", seed, press, lamp.log())
                        .isEqualTo(lamp.truth());
            }
            System.out.println(presses + " presses, seed " + seed + ": " + lamp.logged("loses") + " commands lost, "
                    + doubts + " doubts");
            assertThat(lamp.logged("loses")).isPositive().isLessThanOrEqualTo(doubts);
        }
    }

    private static void assemble(
            SystemEventConverter converter, BrokerConnection connection, SystemClock clock, PushMonitor wall) {
        MqttDevice device = new MqttDevice(connection, clock);
        converter.addMonitor(wall);
        converter.addMonitor(new MqttMonitor("Reports", connection).found("z2m/lamp", STATES));
        converter.addExecute(
                new MqttExecute("Lamp", device, Map.of("toggle", Message.command("z2m/lamp/set", "toggle")))
                        .confirmedBy("z2m/lamp", STATES, LIMIT)
                        .asking(Message.command("z2m/lamp/get", ""), "z2m/lamp", STATES, LIMIT));
        converter.addKnowledge(new StateKnowledge(new ModelPair(MODEL, MODEL)) {
            @Override
            protected void registerNewFunctions() {}
        });
        converter.addLink(device);
        converter.build();
        converter.start();
    }
}
