package org.evoloop.http;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.awaitility.Awaitility.await;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.evoloop.Machines;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.function.Reading;
import org.evoloop.loop.LoopConfig;
import org.evoloop.payload.Match;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.Part;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** An espresso machine at the JDK's HTTP server, which never calls anybody. */
class HttpPollTest {
    private static final Duration PATIENCE = Duration.ofSeconds(60);
    private static final Duration SECOND = Duration.ofSeconds(1);
    private static final Meanings STATES =
            Meanings.at("/state", Map.of("off", "Off", "heating", "Heating", "ready", "Ready", "brewing", "Brewing"));

    private static final StateMachine MODEL = Machines.machine(
            "espresso",
            "Off power -> Heating",
            "Heating power -> Off",
            "Heating heated -> Ready",
            "Ready power -> Off",
            "Ready brew -> Brewing",
            "Ready autoOff -> Off",
            "Brewing brewed -> Ready",
            "Off set => Off");

    private final ManualClock clock = new ManualClock();
    private final SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("espresso", clock));
    private final PushMonitor buttons = new PushMonitor("Buttons");
    private final List<String> posted = new CopyOnWriteArrayList<>();
    private final AtomicInteger asked = new AtomicInteger();
    private HttpServer machine;
    private HttpPoll poll;
    private volatile String state = "{\"state\":\"off\",\"temp\":20}";
    private volatile int status = 200;
    private volatile Runnable whenPosted = () -> {};

    @BeforeEach
    void configure() throws IOException {
        machine = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        machine.createContext("/state", exchange -> {
            asked.incrementAndGet();
            answer(exchange, status, state);
        });
        machine.createContext("/button", exchange -> {
            posted.add(exchange.getRequestURI() + " "
                    + new String(exchange.getRequestBody().readAllBytes(), StandardCharsets.UTF_8) + " "
                    + exchange.getRequestHeaders().getFirst("Authorization"));
            whenPosted.run();
            answer(exchange, 200, "done");
        });
        machine.start();
        HttpExecute execute = new HttpExecute(
                        "Buttons of the machine",
                        Map.of(
                                "power",
                                        HttpCall.post(url("/button/power"), "")
                                                .header("Authorization", "Bearer s3cret"),
                                "brew", HttpCall.post(url("/button/brew"), ""),
                                "set", HttpCall.post(url("/button/set?to=${degrees}"), "{\"who\":\"${who}\"}")),
                        PATIENCE)
                .asking(HttpCall.get(url("/state")), STATES)
                .watch(Duration.ofDays(1));
        poll = new HttpPoll("Machine", converter, HttpCall.get(url("/state")), SECOND, PATIENCE)
                .found(STATES)
                .inferring("heated", "brewed", "autoOff")
                .device(Meanings.NONE.with(Match.exactly("true").at("/heated"), "heated"))
                .reading("water", Part.at("/temp"), "°C")
                .beside(execute);
        converter.addMonitor(poll);
        converter.addMonitor(buttons);
        converter.addExecute(execute);
        converter.addKnowledge(new StateKnowledge(new ModelPair(MODEL, MODEL)) {
            @Override
            protected void registerNewFunctions() {}
        });
        converter.addLink(poll);
        converter.build();
        converter.start();
        poll.open();
        awaitPoll();
    }

    @AfterEach
    void close() {
        poll.close();
        converter.close();
        machine.stop(0);
        clock.close();
    }

    /** The last question is up to a second old. */
    @Test
    void whatTheDeviceHasDoneSinceTheLastQuestionIsKnownBeforeAStepIsSent() {
        shows("heating");

        assertThat(buttons.submit("power").join().isHandled()).isTrue();

        assertThat(posted).hasSize(1);
        assertThat(converter.status().states().original()).hasToString("Off");
    }

    @Test
    void anEffectThatDoesNotShowYetIsNoActOfTheDevice() {
        assertThat(buttons.submit("power").join().isHandled()).isTrue();
        assertThat(buttons.submit("power").join().isHandled()).isTrue();
        assertThat(converter.status().states().original()).hasToString("Off");
        assertThat(posted).hasSize(2);

        clock.advance(SECOND.minusMillis(1));
        assertThat(buttons.submit("power").join().isHandled()).isTrue();
        assertThat(converter.status().states().original()).hasToString("Heating");
    }

    private static void answer(HttpExchange exchange, int status, String body) throws IOException {
        byte[] bytes = body.getBytes(StandardCharsets.UTF_8);
        exchange.sendResponseHeaders(status, bytes.length);
        exchange.getResponseBody().write(bytes);
        exchange.close();
    }

    private String url(String path) {
        return "http://127.0.0.1:" + machine.getAddress().getPort() + path;
    }

    private void shows(String shown) {
        state = "{\"state\":\"" + shown + "\",\"temp\":93}";
    }

    /** The pause after an answer has begun. */
    private void awaitPoll() {
        await().atMost(PATIENCE)
                .until(() -> asked.get() > 0
                        && clock.untilNext().filter(SECOND::equals).isPresent());
    }

    private void nextPoll() {
        int before = asked.get();
        clock.advance(SECOND);
        await().atMost(PATIENCE).until(() -> asked.get() > before);
        awaitPoll();
    }

    private String record() {
        return converter.status().states().original().name();
    }

    private void awaitRecord(String wanted) {
        await().atMost(PATIENCE).untilAsserted(() -> assertThat(record()).isEqualTo(wanted));
    }

    private long occurrences(String label) {
        return converter.history().stream()
                .filter(entry -> entry.occurrence().label().equals(label)
                        && entry.occurrence().source() == Source.DEVICE)
                .count();
    }

    @Test
    void aChangeIsTheDevicesOwnEventIfThereIsOneWayAndElseAFinding() {
        shows("ready");
        nextPoll();
        awaitRecord("Ready");
        assertThat(occurrences("heated") + occurrences("autoOff")).isZero();
        shows("off");
        nextPoll();
        awaitRecord("Off");
        assertThat(occurrences("autoOff")).isEqualTo(1);
        shows("heating");
        nextPoll();
        awaitRecord("Heating");
        shows("ready");
        nextPoll();
        nextPoll();
        awaitRecord("Ready");
        assertThat(occurrences("heated")).isEqualTo(1);
        assertThat(poll.readings()).containsExactly(Reading.of("water", 93.0, "°C"));
        assertThat(converter.status().doubt()).isEmpty();
    }

    @Test
    void whatMustBeSteadyCountsAtTheFirstAnswerAfterItsTime() {
        poll.found(STATES.lasting(SECOND.multipliedBy(2)));
        shows("ready");
        nextPoll();
        shows("heating");
        nextPoll();
        shows("ready");
        nextPoll();
        nextPoll();
        assertThat(record()).isEqualTo("Off");
        nextPoll();
        awaitRecord("Ready");
    }

    @Test
    void aStepThatTheDeviceHasCarriedOutIsNotTakenForItsOwnEvent() {
        shows("ready");
        nextPoll();
        awaitRecord("Ready");
        whenPosted = () -> {
            shows("off");
            int before = asked.get();
            // The next question is due while the step is on its way.
            clock.advance(SECOND);
            assertThat(asked.get()).isEqualTo(before);
        };
        buttons.press("power");
        awaitRecord("Off");
        await().atMost(PATIENCE)
                .until(() -> clock.untilNext().filter(SECOND::equals).isPresent());
        nextPoll();
        assertThat(record()).isEqualTo("Off");
        assertThat(occurrences("autoOff")).isZero();
        assertThat(converter.status().doubt()).isEmpty();
        assertThat(posted).containsExactly("/button/power  Bearer s3cret");
    }

    @Test
    void aStepWithoutEffectIsFoundOut() {
        buttons.press("power");
        awaitRecord("Heating");
        nextPoll();
        awaitRecord("Off");
    }

    @Test
    void garbageIsNoState() {
        for (String garbage : List.of("", "off", "{\"state\":\"re", "{\"state\":7}", "{\"state\":\"melting\"}", "\0")) {
            state = garbage;
            nextPoll();
        }
        assertThat(record()).isEqualTo("Off");
        assertThat(poll.isUp()).isTrue();
    }

    @Test
    void theDeviceIsGoneAfterThreeMissedAnswers() {
        status = 503;
        nextPoll();
        nextPoll();
        assertThat(poll.isUp()).isTrue();
        assertThat(poll.readings()).hasSize(1);
        nextPoll();
        await().atMost(PATIENCE).until(() -> !poll.isUp());
        assertThat(poll.describe()).contains("503");
        assertThat(poll.downSince()).isPresent();
        assertThat(poll.readings()).isEmpty();
        status = 200;
        shows("ready");
        nextPoll();
        awaitRecord("Ready");
        assertThat(poll.isUp()).isTrue();
        assertThatIllegalArgumentException().isThrownBy(() -> poll.downAfter(0));
    }

    @Test
    void anEventOccursWhenTheAnswerBeginsToMeanIt() {
        shows("heating");
        nextPoll();
        awaitRecord("Heating");
        state = "{\"heated\":true}";
        nextPoll();
        nextPoll();
        awaitRecord("Ready");
        assertThat(occurrences("heated")).isEqualTo(1);
    }

    @Test
    void anEventsValuesAreInTheRequest() {
        buttons.press("set", Values.of("degrees", 21.5).with("who", "a/\"b\""));
        await().atMost(PATIENCE).until(() -> posted.size() == 1);
        assertThat(posted).containsExactly("/button/set?to=21.5 {\"who\":\"a/\\\"b\\\"\"} null");
        buttons.press("set");
        await().atMost(PATIENCE)
                .untilAsserted(() -> assertThat(converter.history())
                        .anyMatch(entry -> entry.detail().contains("the event carries no degrees")));
        assertThat(posted).hasSize(1);
    }
}
