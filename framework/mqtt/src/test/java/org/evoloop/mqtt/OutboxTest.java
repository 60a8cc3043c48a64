package org.evoloop.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class OutboxTest {
    private final Outbox outbox = new Outbox();

    private List<String> taken() throws InterruptedException {
        List<String> all = new ArrayList<>();
        while (!outbox.isEmpty()) {
            all.add(outbox.take(() -> true).payload());
        }
        return all;
    }

    @Test
    void ofStatesOnlyTheNewestOfATopicIsKept() throws Exception {
        outbox.put(Message.state("a", "1"));
        outbox.put(Message.state("b", "1"));
        outbox.put(Message.state("a", "2"));
        assertThat(taken()).containsExactly("2", "1");
    }

    @Test
    void aStateThatIsAtTheBrokerIsNotTakenAgain() throws Exception {
        outbox.put(Message.state("a", "1"));
        taken();
        outbox.put(Message.state("a", "1"));
        assertThat(taken()).isEmpty();
    }

    @Test
    void afterAReconnectEveryStateIsDueAgain() throws Exception {
        outbox.put(Message.state("a", "1"));
        outbox.put(Message.event("e", "gone"));
        taken();
        outbox.republish();
        assertThat(taken()).containsExactly("1");
    }

    @Test
    void whatDidNotArriveIsTakenAgainUnlessItIsOutdated() throws Exception {
        outbox.put(Message.state("a", "old"));
        Message under = outbox.take(() -> true);
        outbox.put(Message.state("a", "new"));
        outbox.giveBack(under);
        assertThat(taken()).containsExactly("new");

        outbox.put(Message.event("e", "first"));
        outbox.put(Message.event("e", "second"));
        outbox.giveBack(outbox.take(() -> true));
        assertThat(taken()).containsExactly("first", "second");
    }

    @Test
    void commandsOfAnotherTimeAreNotGiven() throws Exception {
        outbox.put(Message.command("c", "now"));
        outbox.put(Message.event("e", "event"));
        outbox.discardCommands();
        assertThat(taken()).containsExactly("event");
    }

    @Test
    void theOldestAreLostWhenTooManyWait() throws Exception {
        for (int i = 0; i < Outbox.MOST_WAITING + 10; i++) {
            outbox.put(Message.event("e", Integer.toString(i)));
        }
        assertThat(outbox.lost()).isEqualTo(10);
        assertThat(taken()).hasSize(Outbox.MOST_WAITING).startsWith("10");
    }

    @Test
    void statesOfTooManyTopicsAreLost() throws Exception {
        for (int i = 0; i < Outbox.MOST_TOPICS + 3; i++) {
            outbox.put(Message.state("topic/" + i, "1"));
        }
        outbox.put(Message.state("topic/0", "2"));
        assertThat(outbox.lost()).isEqualTo(3);
        assertThat(taken()).hasSize(Outbox.MOST_TOPICS).startsWith("2");
    }

    @Test
    void takeReturnsNullWhenWaitingIsPointless() throws Exception {
        assertThat(outbox.take(() -> false)).isNull();
    }
}
