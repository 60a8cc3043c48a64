package org.evoloop.engine.codec;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.junit.jupiter.api.Test;

/** What a journal stores: records one after another, in which a name is spelt out once. */
class ElementsTest {
    private static final StateMachine LAMP = StateMachine.named("lamp")
            .initial("off")
            .transition("off", "switch", "on")
            .transition("on", "switch", "off")
            .build();
    private static final ModelPair MODELS = new ModelPair(LAMP, LAMP.withName("new"));
    private static final Event SWITCH = new Event("switch");

    private final long seed = new Random().nextLong();
    private final Random random = new Random(seed);

    private String text() {
        return random.ints(random.nextInt(20), 0, 1 << 16)
                .collect(StringBuilder::new, (all, each) -> all.append((char) each), StringBuilder::append)
                .toString();
    }

    private long number() {
        return random.nextLong() >> random.nextInt(Long.SIZE);
    }

    private Values values() {
        Map<String, Object> values = new TreeMap<>();
        for (int left = random.nextInt(4); left > 0; left--) {
            values.put(
                    text(),
                    random.nextBoolean()
                            ? text()
                            : random.nextBoolean() ? Double.longBitsToDouble(random.nextLong()) : (Object) true);
        }
        return new Values(values);
    }

    private Occurrence occurrence() {
        Source source = Source.values()[random.nextInt(Source.values().length)];
        boolean acted = source != Source.TIMER && random.nextBoolean();
        return switch (random.nextInt(6)) {
            case 0 -> new Occurrence.Asked(new Event("any " + random.nextInt(9)), values(), number(), number());
            case 1 -> new Occurrence.Found(new State("unknown"), number());
            case 2 -> new Occurrence.InDoubt("why " + text(), number());
            case 3 -> new Occurrence.Violated("property " + text(), number());
            case 4 -> new Occurrence.Evolved("models " + text(), number());
            default -> new Occurrence.Heard(SWITCH, values(), source, acted, Set.of("a", "b"), number(), number());
        };
    }

    private Decision decision() {
        Transition taken = LAMP.transition(new State("off"), SWITCH).orElseThrow();
        Configuration before = new Configuration(new State("off"), new State("off"));
        Configuration after = new Configuration(new State("on"), new State("on"));
        List<Step> steps = List.of(new Step(taken, SWITCH, random.nextBoolean(), random.nextBoolean()));
        return switch (random.nextInt(5)) {
            case 0 -> new Decision.ExistingState(before, after, steps, taken, List.of("light"));
            case 1 -> new Decision.NewState(before, after, steps, taken, List.of());
            case 2 -> new Decision.NotAcceptable(before, after, steps);
            case 3 -> new Decision.Impossible(before, after, steps, null, text());
            default -> new Decision.Refused(before, text());
        };
    }

    @Test
    void recordsAreReadAsTheyWereWritten() {
        ByteWriter writer = ByteWriter.withTable();
        ElementWriter elements = new ElementWriter(writer);
        List<Object> written = new ArrayList<>();
        List<Integer> ends = new ArrayList<>();
        for (int record = 0; record < 2_000; record++) {
            Object element = random.nextBoolean() ? occurrence() : decision();
            if (element instanceof Occurrence occurrence) {
                elements.occurrence(occurrence);
            } else {
                elements.decision((Decision) element);
            }
            written.add(element);
            ends.add(writer.length());
        }
        ByteItems items = ByteItems.withTable(writer.written());
        ElementReader reader = new ElementReader(MODELS, items);
        int from = 0;
        for (int record = 0; record < written.size(); record++) {
            Object element = written.get(record);
            items.goTo(from, ends.get(record) - from);
            from = ends.get(record);
            assertThat(element instanceof Occurrence ? reader.occurrence() : reader.decision())
                    .as("seed %d, record %d", seed, record)
                    .isEqualTo(element);
            items.endsAll();
        }
    }

    @Test
    void aNameIsSpeltOutOnceUntilItIsForgotten() {
        ByteWriter writer = ByteWriter.withTable();
        writer.name("switch");
        int first = writer.length();
        writer.clear();
        writer.name("switch");
        assertThat(first).isGreaterThan(7);
        assertThat(writer.length()).isOne();
        writer.clear();
        writer.forgetNames();
        writer.name("switch");
        assertThat(writer.length()).isEqualTo(first);
    }

    @Test
    void whateverIsDamagedIsReadOrRefused() {
        ByteWriter writer = ByteWriter.withTable();
        ElementWriter elements = new ElementWriter(writer);
        elements.occurrence(new Occurrence.Heard(SWITCH, Values.of("a", 0.5), Source.PANEL, false, Set.of("g"), 1, 2));
        int end = writer.length();
        elements.decision(decision());
        byte[] bytes = writer.written();
        int refused = 0;
        for (int round = 0; round < 20_000; round++) {
            byte[] damaged = bytes.clone();
            damaged[random.nextInt(bytes.length)] = (byte) random.nextInt();
            ByteItems items = ByteItems.withTable(damaged);
            ElementReader reader = new ElementReader(MODELS, items);
            try {
                items.goTo(0, end);
                reader.occurrence();
                items.endsAll();
                items.goTo(end, bytes.length - end);
                reader.decision();
                items.endsAll();
            } catch (CodecException e) {
                refused++;
            }
        }
        assertThat(refused).as("seed %d", seed).isGreaterThan(5_000);
    }

    @Test
    void aNameThatIsNotInTheTableIsRefused() {
        ByteWriter writer = new ByteWriter();
        writer.number(1);
        assertThatThrownBy(() -> ByteItems.withTable(writer.written()).name())
                .isInstanceOf(CodecException.class)
                .hasMessage("a name has the number 1 of 0");
    }

    @Test
    void aCountOfManyTakesNoMemory() {
        ByteWriter writer = new ByteWriter();
        writer.number(Integer.MAX_VALUE);
        assertThatThrownBy(() -> new ByteItems("it", writer.written(), 0).names())
                .hasMessage("it, before byte 5: they end too early; the bytes are damaged, use another copy or start"
                        + " without it");
    }

    @Test
    void tooManyValuesAreDamage() {
        ByteWriter writer = new ByteWriter();
        new ElementWriter(writer).occurrence(new Occurrence.Asked(SWITCH, Values.of("a", "x".repeat(16_000)), 0, 1));
        byte[] bytes = writer.written();
        ByteWriter more = new ByteWriter();
        more.word("asked").number(1).number(0).name("switch").number(0).number(2);
        more.name("a").value("x".repeat(16_000)).name("b").value("x".repeat(16_000));
        assertThat(new ElementReader(MODELS, new ByteItems("it", bytes, 0)).occurrence())
                .isInstanceOf(Occurrence.Asked.class);
        assertThatThrownBy(() -> new ElementReader(MODELS, new ByteItems("it", more.written(), 0)).occurrence())
                .isInstanceOf(CodecException.class)
                .hasMessageContaining("characters");
    }
}
