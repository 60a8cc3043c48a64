package org.evoloop.homeassistant;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.Map;
import java.util.Queue;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.evoloop.Machines;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.imitation.Faults;
import org.evoloop.imitation.Imitation;
import org.evoloop.loop.LoopConfig;
import org.evoloop.payload.JsonRecord;
import org.evoloop.payload.Meanings;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * A lamp in an imitated Home Assistant that loses commands, obeys and reports late, sometimes too late; services fail, and
 * connections are lost. The lamp's own log is the truth: the converter's record is never wrong without a doubt.
 */
class LossyHomeTest {
    private static final Duration PATIENCE = Duration.ofSeconds(60);
    private static final Duration LIMIT = Duration.ofMillis(300);
    private static final EntityValue LAMP = EntityValue.state("light.lamp");
    private static final StateMachine MODEL = Machines.machine("lamp", "off toggle -> on", "on toggle -> off");
    private static final Meanings STATES = Meanings.of(Map.of("on", "on", "off", "off"));

    @Test
    void aFewPresses() throws Exception {
        Faults many =
                new Faults(20, 10, 20, LIMIT.dividedBy(2), LIMIT.multipliedBy(6).dividedBy(5));
        press(40, many, 7);
    }

    @Test
    @Tag("slow")
    void fiveHundredPresses() throws Exception {
        press(500, Faults.around(LIMIT), Long.getLong("evoloop.seed", new Random().nextLong()));
    }

    private void press(int presses, Faults faults, long seed) throws Exception {
        Random random = new Random(seed);
        Queue<CompletableFuture<String>> polls = new ConcurrentLinkedQueue<>();
        try (HomeImitation home = new HomeImitation();
                Imitation lamp = new Imitation(MODEL, faults, seed);
                SystemClock clock = new SystemClock();
                HomeConnection connection =
                        new HomeConnection(HomeAddress.parse(home.url()), () -> HomeImitation.TOKEN);
                SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock))) {
            home.put("light.lamp", "off");
            home.with(call -> serve(call, lamp, polls, random));
            lamp.reportingTo(state -> {
                home.put("light.lamp", state);
                for (CompletableFuture<String> poll = polls.poll(); poll != null; poll = polls.poll()) {
                    poll.complete("");
                }
            });
            PushMonitor wall = new PushMonitor("Wall");
            assemble(converter, connection, clock, wall);
            connection.open();
            await().atMost(PATIENCE).until(connection::isUp);
            int doubts = 0;
            int drops = 0;
            for (int press = 1; press <= presses; press++) {
                CompletableFuture<?> pressed = wall.submit("toggle");
                if (random.nextInt(20) == 0) {
                    drops++;
                    home.drop();
                }
                pressed.join();
                doubts += converter.status().doubt().isEmpty() ? 0 : 1;
                await().pollInterval(Duration.ofMillis(2))
                        .atMost(PATIENCE)
                        .until(() ->
                                connection.isUp() && converter.status().doubt().isEmpty());
                ConverterStatus status = converter.status();
                assertThat(status.states().original().name())
                        .as("seed %d, press %d, the lamp %s", seed, press, lamp.log())
                        .isEqualTo(lamp.truth());
            }
            System.out.println(presses + " presses, seed " + seed + ": " + lamp.logged("loses") + " commands lost, "
                    + drops + " connections, " + doubts + " doubts");
            assertThat(lamp.logged("loses")).isPositive().isLessThanOrEqualTo(doubts);
        }
    }

    private static CompletableFuture<String> serve(
            JsonRecord call, Imitation lamp, Queue<CompletableFuture<String>> polls, Random random) {
        if (call.text("service").equals("update_entity")) {
            CompletableFuture<String> poll = new CompletableFuture<>();
            polls.add(poll);
            lamp.ask();
            return poll;
        }
        lamp.take("toggle");
        return random.nextInt(20) == 0
                ? HomeImitation.failed("home_assistant_error The device did not answer")
                : HomeImitation.done();
    }

    private static void assemble(
            SystemEventConverter converter, HomeConnection connection, SystemClock clock, PushMonitor wall) {
        HomeDevice device = new HomeDevice(connection, clock);
        converter.addMonitor(wall);
        converter.addMonitor(new HomeMonitor("Reports", device).found(LAMP, STATES));
        converter.addExecute(new HomeExecute(
                        "Lamp", device, Map.of("toggle", ServiceCall.of("light.toggle", LAMP.entity())))
                .confirmedBy(LAMP, STATES, LIMIT)
                .askedWithin(LIMIT.multipliedBy(3)));
        converter.addKnowledge(new StateKnowledge(new ModelPair(MODEL, MODEL)) {
            @Override
            protected void registerNewFunctions() {}
        });
        converter.addLink(device);
        converter.build();
        converter.start();
    }
}
