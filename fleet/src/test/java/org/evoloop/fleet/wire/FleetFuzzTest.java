package org.evoloop.fleet.wire;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import java.util.regex.Pattern;
import org.apache.kafka.common.serialization.ByteArrayDeserializer;
import org.apache.kafka.common.serialization.ByteArraySerializer;
import org.apache.kafka.common.serialization.StringDeserializer;
import org.apache.kafka.common.serialization.StringSerializer;
import org.apache.kafka.streams.KeyValue;
import org.apache.kafka.streams.StreamsConfig;
import org.apache.kafka.streams.TestInputTopic;
import org.apache.kafka.streams.TestOutputTopic;
import org.apache.kafka.streams.TopologyTestDriver;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.device.Order;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.stream.FleetTopology;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.provider.MethodSource;
import org.slf4j.LoggerFactory;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * A record of any bytes is read or refused, and affects no other record. The topology is the fleet's; its time and broker are
 * Kafka Streams' own for tests.
 */
@Timeout(60)
class FleetFuzzTest {
    private static final JsonMapper MAPPER = new JsonMapper();
    private static final List<Topic> TOPICS = List.of(
            Topic.OCCURRENCES,
            Topic.EFFECTS,
            Topic.DEVICES,
            Topic.MODELS,
            Topic.ROLLOUTS,
            Topic.VERDICTS,
            Topic.COMMANDS);

    private static final Set<Topic> BY_DEVICE = EnumSet.of(Topic.OCCURRENCES, Topic.EFFECTS, Topic.DEVICES);

    private static final String GOOD = "good";
    private static final String WATCHED = "watched";
    private static final String ODD = "odd";
    private static final String OTHER = "other";
    private static final String STRANGER = "stranger";
    private static final @Nullable String[] KEYS = {GOOD, OTHER, STRANGER, null};
    private static final Pattern TIME = Pattern.compile("\\b[0-9]{13}\\b");

    /** The number of records after which a fleet is replaced: its counts and times grow. */
    private static final int MOST = 500;

    private static final Instant BEGIN = Instant.ofEpochMilli(1_800_000_000_000L);

    // Reading and writing

    /** Reads the record; writes what was read, reads that, and requires that it is the same. Null if it is refused. */
    private static @Nullable Object read(Topic topic, byte[] bytes) {
        Object read;
        try {
            read = parsed(topic, bytes);
        } catch (Refusal refusal) {
            assertThat(refusal.detail()).isNotBlank();
            return null;
        }
        byte[] written = written(read);
        assertThat(MAPPER.readTree(written).isObject()).isTrue();
        assertThat(parsed(topic, written)).isEqualTo(read);
        return read;
    }

    private static Object parsed(Topic topic, byte[] bytes) {
        return switch (topic) {
            case OCCURRENCES -> Reading.of(bytes).occurrence();
            case EFFECTS -> Reading.of(bytes).answer();
            case COMMANDS -> Reading.of(bytes).order();
            case DEVICES -> Reading.of(bytes).record().text("model");
            case MODELS -> ModelRecord.of(Reading.of(bytes).record());
            case ROLLOUTS -> Rollout.read(ODD, bytes);
            default -> throw new Refusal(Refusal.Reason.MALFORMED, "it is not JSON");
        };
    }

    private static byte[] written(Object read) {
        if (read instanceof Occurrence occurrence) {
            return Wire.occurrence(occurrence, 7);
        } else if (read instanceof Answer answer) {
            return Wire.effect(answer);
        } else if (read instanceof Order order) {
            return Wire.command(order);
        } else if (read instanceof ModelRecord models) {
            return models.bytes();
        } else if (read instanceof Rollout rollout) {
            return rollout.bytes();
        }
        return Wire.device((String) read);
    }

    // The topology

    /** A record between two of a device. */
    @SuppressWarnings("ArrayRecordComponent") // nobody compares them
    private record Odd(Topic topic, @Nullable String key, byte[] bytes) {}

    /** A device's records, except dead letters, with times relative to the begin; and all dead letters. */
    private record Result(List<String> good, List<JsonNode> letters, boolean strangerIsKnown) {}

    private static final class Parts implements AutoCloseable {
        private final FleetSettings settings =
                FleetSettings.defaults().withFleet("fuzz").withDevicesInMemory();
        private final ListAppender<ILoggingEvent> log = new ListAppender<>();
        private final TopologyTestDriver driver;
        private final Map<Topic, TestInputTopic<String, byte[]>> inputs = new EnumMap<>(Topic.class);
        private final Map<Topic, TestOutputTopic<String, byte[]>> outputs = new EnumMap<>(Topic.class);
        private long nowMillis = BEGIN.toEpochMilli();
        private int stories;

        Parts() {
            Properties properties = new Properties();
            properties.put(StreamsConfig.APPLICATION_ID_CONFIG, settings.fleet());
            driver = new TopologyTestDriver(FleetTopology.of(settings), properties, BEGIN);
            for (Topic topic : TOPICS) {
                if (topic != Topic.COMMANDS) {
                    inputs.put(
                            topic,
                            driver.createInputTopic(
                                    topic.of(settings.fleet()), new StringSerializer(), new ByteArraySerializer()));
                }
            }
            for (Topic topic :
                    List.of(Topic.COMMANDS, Topic.DECISIONS, Topic.STATES, Topic.DEAD_LETTERS, Topic.ROLLOUTS)) {
                outputs.put(
                        topic,
                        driver.createOutputTopic(
                                topic.of(settings.fleet()), new StringDeserializer(), new ByteArrayDeserializer()));
            }
            log.start();
            logger().addAppender(log);
            write(Topic.MODELS, "lamp-1", Models.LAMP.bytes());
            write(Topic.MODELS, "lamp-2", Models.lamp(1_000).bytes());
            write(Topic.ROLLOUTS, WATCHED, new Rollout(WATCHED, "lamp-1", "lamp-2", 0, "", 5, 20, "").bytes());
        }

        private static Logger logger() {
            return (Logger) LoggerFactory.getLogger("org.evoloop.fleet.stream");
        }

        private void write(Topic topic, @Nullable String key, byte @Nullable [] record) {
            boolean isDevice = key != null && BY_DEVICE.contains(topic);
            inputs.get(topic).pipeInput(isDevice ? id(key) : key, record, nowMillis);
        }

        /** Each story has its own devices: one that comes back would continue its numbers. */
        private String id(String device) {
            return device + '-' + stories;
        }

        private void pass(long millis) {
            driver.advanceWallClockTime(Duration.ofMillis(millis));
            nowMillis += millis;
        }

        private void press(String device) {
            Event event = new Event("switch");
            write(
                    Topic.OCCURRENCES,
                    device,
                    Wire.occurrence(
                            new Occurrence.Heard(
                                    event, Values.NONE, Source.PANEL, Occurrence.ANY_VISIT, Wire.nanos(nowMillis)),
                            0));
        }

        private void answer(String device, long sequence) {
            Answer answer = new Answer(sequence, Answer.Outcome.SENT, "", null, Wire.nanos(nowMillis));
            write(Topic.EFFECTS, device, Wire.effect(answer));
        }

        /** What two devices do, with a record in between. */
        Result story(@Nullable Odd odd) {
            long beginMillis = nowMillis;
            stories++;
            log.list.clear();
            for (String device : List.of(GOOD, OTHER)) {
                write(Topic.DEVICES, device, Wire.device("lamp-1"));
                press(device);
            }
            if (odd != null) {
                write(odd.topic, odd.key, odd.bytes);
                if (odd.topic == Topic.MODELS) {
                    write(Topic.DEVICES, STRANGER, Wire.device(ODD));
                    press(STRANGER);
                    answer(STRANGER, 1);
                }
            }
            answer(GOOD, 1);
            pass(600);
            press(GOOD);
            pass(3_000);
            answer(GOOD, 2);
            press(GOOD);
            answer(GOOD, 3);
            Result result = result(beginMillis);
            for (String device : List.of(GOOD, OTHER, STRANGER)) {
                write(Topic.DEVICES, device, null);
            }
            outputs.values().forEach(TestOutputTopic::readKeyValuesToList);
            assertThat(log.list)
                    .extracting(ILoggingEvent::getMessage)
                    .noneMatch(pattern -> pattern.contains("this is a defect"));
            return result;
        }

        private Result result(long beginMillis) {
            List<String> good = new ArrayList<>();
            List<JsonNode> letters = new ArrayList<>();
            boolean strangerIsKnown = false;
            for (Map.Entry<Topic, TestOutputTopic<String, byte[]>> output : outputs.entrySet()) {
                for (KeyValue<String, byte[]> record : output.getValue().readKeyValuesToList()) {
                    JsonNode json = MAPPER.readTree(record.value);
                    if (output.getKey() == Topic.DEAD_LETTERS) {
                        letters.add(json);
                    } else if (id(GOOD).equals(record.key)) {
                        good.add(output.getKey() + " "
                                + TIME.matcher(Wire.text(record.value))
                                        .replaceAll(time -> "" + (Long.parseLong(time.group()) - beginMillis)));
                    } else if (id(STRANGER).equals(record.key)) {
                        strangerIsKnown = true;
                    }
                }
            }
            return new Result(good, letters, strangerIsKnown);
        }

        @Override
        public void close() {
            logger().detachAppender(log);
            driver.close();
        }
    }

    private static @Nullable Parts parts;
    private static List<String> expected = List.of();

    private static Parts parts() {
        Parts current = parts;
        if (current == null) {
            current = new Parts();
            parts = current;
            if (expected.isEmpty()) {
                expected = current.story(null).good;
                assertThat(expected)
                        .anyMatch(record -> record.startsWith("COMMANDS"))
                        .anyMatch(record -> record.startsWith("DECISIONS") && record.contains("handled"));
            }
        }
        return current;
    }

    private static void replaceParts() {
        if (parts != null) {
            parts.close();
            parts = null;
        }
    }

    @AfterAll
    static void close() {
        replaceParts();
    }

    /** @param bytes the first one chooses the topic and the key; the rest is the record */
    @MethodSource("seeds")
    @FuzzTest
    void aRecordOfAnyBytesIsReadOrRefusedAndAffectsNoOther(byte[] bytes) {
        if (bytes.length == 0) {
            return;
        }
        int choice = bytes[0] & 0xff;
        Topic topic = TOPICS.get(choice % TOPICS.size());
        byte[] record = Arrays.copyOfRange(bytes, 1, bytes.length);
        Object read = read(topic, record);
        if (topic == Topic.COMMANDS) {
            return;
        }
        String key = KEYS[choice / TOPICS.size() % KEYS.length];
        if (key != null && !BY_DEVICE.contains(topic)) {
            key = topic == Topic.VERDICTS ? WATCHED : ODD;
        }
        Parts current = parts();
        boolean whole = false;
        try {
            Result result = current.story(new Odd(topic, key, record));
            requireLetters(topic, record, read, result.letters);
            boolean mayDiffer =
                    read != null && (topic == Topic.ROLLOUTS || (GOOD.equals(key) && result.letters.isEmpty()));
            if (!mayDiffer) {
                assertThat(result.good).isEqualTo(expected);
            }
            // What was accepted may concern later devices.
            boolean lasts = topic == Topic.ROLLOUTS && read != null;
            whole = !lasts && !(topic == Topic.MODELS && result.strangerIsKnown) && current.stories < MOST;
        } finally {
            if (!whole) {
                replaceParts();
            }
        }
    }

    private static void requireLetters(Topic topic, byte[] record, @Nullable Object read, List<JsonNode> letters) {
        assertThat(letters)
                .allSatisfy(letter ->
                        assertThat(letter.path("detail").stringValue()).isNotBlank())
                .noneMatch(letter -> letter.path("reason").stringValue().equals("defect"));
        if (BY_DEVICE.contains(topic)) {
            String text = Base64.getEncoder().encodeToString(record);
            assertThat(letters)
                    .hasSizeBetween(read == null ? 1 : 0, 1)
                    .allMatch(letter -> letter.path("record").stringValue().equals(text));
        }
    }

    static List<byte[]> seeds() {
        String at = ",\"atMillis\":" + BEGIN.toEpochMilli();
        String models = "{\"schema\":1,\"file\":\"lamp.scxml\",\"original\":\"lamp\",\"new\":\"lamp\",\"queue\":8,"
                + "\"timers\":[{\"state\":\"on\",\"event\":\"switch\",\"millis\":2000}],\"text\":\""
                + "<scxml xmlns='http://www.w3.org/2005/07/scxml' name='lamp' initial='off'><state id='off'>"
                + "<transition event='switch' target='on'/></state><state id='on'>"
                + "<transition event='switch' target='off'/></state></scxml>\"}";
        String other = Wire.text(new Rollout(ODD, "lamp-1", "lamp-2", 100, "", 5, 20, "").bytes());
        return List.of(
                seed(Topic.OCCURRENCES, 0, "{\"schema\":1,\"schema\":1,\"number\":7,\"event\":\"switch\"" + at + "}"),
                seed(
                        Topic.OCCURRENCES,
                        0,
                        "{\"schema\":1,\"event\":\"switch\",\"values\":{\"level\":1e999}" + at + "}"),
                seed(
                        Topic.OCCURRENCES,
                        1,
                        "{\"schema\":1,\"kind\":\"heard\",\"event\":\"switch\",\"source\":\"device\",\"deviceActed\":true,"
                                + "\"holding\":[\"dark\"],\"visit\":1,\"values\":{\"a\":1.5,\"b\":\"c\",\"d\":true}"
                                + at + "}"),
                seed(Topic.OCCURRENCES, 1, "{\"schema\":1,\"schema\":1,\"kind\":\"found\",\"state\":\"on\"" + at + "}"),
                seed(
                        Topic.OCCURRENCES,
                        1,
                        "{\"schema\":1,\"schema\":1,\"kind\":\"asked\",\"event\":\"timeout\"" + at + "}"),
                seed(Topic.OCCURRENCES, 2, "{\"schema\":1,\"event\":\"switch\"" + at + "}"),
                seed(Topic.OCCURRENCES, 3, "{}"),
                seed(Topic.EFFECTS, 1, "{\"schema\":1,\"sequence\":1,\"outcome\":\"sent\",\"state\":\"on\"" + at + "}"),
                seed(
                        Topic.EFFECTS,
                        0,
                        "{\"schema\":1,\"schema\":1,\"sequence\":1,\"outcome\":\"in-doubt\",\"reason\":\"?\"" + at
                                + "}"),
                seed(
                        Topic.EFFECTS,
                        0,
                        "{\"schema\":1,\"schema\":1,\"sequence\":1,\"outcome\":\"failed\",\"state\":\" \"" + at + "}"),
                seed(Topic.DEVICES, 2, "{\"schema\":1,\"model\":\"lamp-2\"}"),
                seed(Topic.DEVICES, 0, "{\"schema\":1,\"model\":\"\\ud83d\"}"),
                seed(Topic.MODELS, 0, models),
                seed(Topic.MODELS, 0, models.replace("2000", "" + Long.MAX_VALUE)),
                seed(Topic.ROLLOUTS, 0, other),
                seed(Topic.ROLLOUTS, 0, other.replace("100.0", "1e999")),
                seed(Topic.MODELS, 3, models),
                seed(Topic.ROLLOUTS, 3, other),
                seed(Topic.VERDICTS, 3, "a result of 16 B"),
                seed(Topic.VERDICTS, 0, "a result"),
                seed(
                        Topic.VERDICTS,
                        0,
                        new String(
                                ByteBuffer.allocate(2 * Long.BYTES)
                                        .putLong(0)
                                        .putLong(100)
                                        .array(),
                                StandardCharsets.ISO_8859_1)),
                seed(
                        Topic.COMMANDS,
                        0,
                        "{\"schema\":1,\"sequence\":1,\"kind\":\"send\",\"deadlineMillis\":1,\"event\":\"switch\",\"from\":\"off\","
                                + "\"to\":\"on\",\"visit\":3,\"function\":false}"),
                seed(
                        Topic.COMMANDS,
                        0,
                        "{\"schema\":1,\"sequence\":1,\"kind\":\"run\",\"deadlineMillis\":1,\"effect\":\"beep\"}"));
    }

    private static byte[] seed(Topic topic, int key, String record) {
        return ((char) (TOPICS.indexOf(topic) + TOPICS.size() * key) + record).getBytes(StandardCharsets.UTF_8);
    }
}
