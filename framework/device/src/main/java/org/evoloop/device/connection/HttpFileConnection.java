package org.evoloop.device.connection;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.config.Secret;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.device.Connection;
import org.evoloop.device.FileModels;
import org.evoloop.device.Outward;
import org.evoloop.device.Parts;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.http.HttpCall;
import org.evoloop.http.HttpExecute;
import org.evoloop.http.HttpPoll;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.Part;
import org.jspecify.annotations.Nullable;

/** A device that answers HTTP requests, made of a {@link HttpPoll} and a {@link HttpExecute}. */
final class HttpFileConnection extends Connection {
    private static final Pattern CALL = Pattern.compile("(?<method>GET|POST|PUT) (?<path>/\\S*)");
    private static final Pattern STATUSES = Pattern.compile("(?<from>[1-9][0-9]{2})(?:\\.\\.(?<to>[1-9][0-9]{2}))?");

    private final FileModels models;
    private final @Nullable String base;
    private final Map<String, String> headers;
    private final Duration within;
    private final @Nullable HttpCall question;
    private final Duration every;
    private final int downAfter;
    private final List<Consumer<HttpPoll>> rules = new ArrayList<>();
    private final Map<String, HttpCall> calls = new LinkedHashMap<>();
    private @Nullable Meanings states;
    private @Nullable Duration ready;

    private HttpFileConnection(String name, Section section, @Nullable String base, FileModels models) {
        super(name, "http");
        this.base = base;
        this.models = models;
        this.headers = new LinkedHashMap<>();
        section.pairs("headers").forEach((key, value) -> header(section, key, Node.Text::value, value));
        section.pairs("header-files").forEach((key, file) -> {
            if (headers.containsKey(key.value())) {
                section.problems().at(key, "the header " + key + " is given twice; keep it in one of both");
            }
            header(section, key, text -> Secret.read(section.problems().file().resolveSibling(text.value())), file);
        });
        this.within = section.duration("within").orElse(Duration.ofSeconds(2));
        this.every = section.period("every").orElse(Duration.ofSeconds(5));
        this.downAfter = section.number("down-after", 1, 1000).orElse(3);
        this.question = section.value("poll", path -> call("GET " + path, "")).orElse(null);
    }

    /** @param value reads the header's value, which may be a secret */
    private void header(Section section, Node.Text key, Function<Node.Text, String> value, Node.Text from) {
        try {
            String text = value.apply(from);
            HttpCall.get("http://any").header(key.value(), text);
            headers.put(key.value(), text);
        } catch (IllegalArgumentException refused) {
            section.problems().at(key, String.valueOf(refused.getMessage()));
        }
    }

    static HttpFileConnection read(String name, Section section, FileModels models) {
        String base = section.value("http", HttpFileConnection::address).orElse(null);
        return new HttpFileConnection(name, section, base, models);
    }

    private static String address(String text) {
        HttpCall.get(text);
        return text.replaceFirst("/+$", "");
    }

    /** @throws IllegalArgumentException if it is no request */
    private HttpCall call(String text, String body) {
        Matcher parts = CALL.matcher(text);
        if (!parts.matches()) {
            throw new IllegalArgumentException(
                    "'" + text.replaceFirst("[?].*", "?...") + "' is no request; write one such as POST /power");
        }
        String address = (base == null ? "http://refused" : base) + parts.group("path");
        HttpCall call = switch (parts.group("method")) {
            case "GET" -> HttpCall.get(address);
            case "PUT" -> HttpCall.put(address, body);
            default -> HttpCall.post(address, body);
        };
        for (Map.Entry<String, String> header : headers.entrySet()) {
            call = call.header(header.getKey(), header.getValue());
        }
        return call;
    }

    @Override
    public String shortSend() {
        return "call";
    }

    @Override
    public void send(Node.Text event, Section how) {
        request(how).ifPresent(call -> calls.put(event.value(), call));
    }

    @Override
    public @Nullable Outward outward(Section action) {
        HttpCall call = request(action).orElse(null);
        return call == null ? null : values -> call.send(values, within);
    }

    private Optional<HttpCall> request(Section how) {
        String body = how.text("body").map(Node.Text::value).orElse("");
        UnaryOperator<HttpCall> accepting =
                how.value("accepted", HttpFileConnection::statuses).orElse(UnaryOperator.identity());
        how.require("call");
        return how.value("call", text -> call(text, body)).map(accepting);
    }

    private static UnaryOperator<HttpCall> statuses(String text) {
        Matcher range = STATUSES.matcher(text);
        if (!range.matches()) {
            throw new IllegalArgumentException("'" + text + "' is no range of statuses; write 200..299 or 204");
        }
        int from = Integer.parseInt(range.group("from"));
        int to = range.group("to") == null ? from : Integer.parseInt(range.group("to"));
        HttpCall.get("http://any").accepting(from, to);
        return call -> call.accepting(from, to);
    }

    private void requirePoll(Section rule) {
        if (question == null) {
            rule.problem("connection " + name() + " is never asked; give it poll, such as {poll: /state, every: 5 s}");
        }
    }

    @Override
    public void state(Section rule) {
        requirePoll(rule);
        Meanings meanings = MeaningReader.read(rule, "state", models::deviceState);
        boolean infers = rule.flag("infer-events").orElse(false);
        if (states != null) {
            rule.problem("what " + name() + " says of the device's state is given twice; keep one");
        }
        states = meanings;
        rules.add(poll -> {
            poll.found(meanings);
            if (infers) {
                poll.inferring();
            }
        });
    }

    @Override
    public void does(Section rule) {
        requirePoll(rule);
        Meanings meanings = MeaningReader.read(rule, "event", models::devicesOwn);
        rules.add(poll -> poll.device(meanings));
    }

    @Override
    public void press(Section rule) {
        requirePoll(rule);
        Meanings meanings = MeaningReader.read(rule, "event", models::pressed);
        rules.add(poll -> poll.controller(meanings));
    }

    @Override
    public void reading(Node.Text reading, Section rule) {
        requirePoll(rule);
        Part part = MeaningReader.part(rule).orElse(Part.WHOLE);
        String unit = rule.text("unit").map(Node.Text::value).orElse("");
        rules.add(poll -> poll.reading(reading.value(), part, unit));
    }

    @Override
    public void device(Section device) {
        ready = device.duration("ready-after").orElse(null);
    }

    @Override
    protected boolean asksByItself() {
        return true;
    }

    @Override
    protected Parts make(SystemEventConverter converter) {
        Optional<HttpExecute> execute =
                calls.isEmpty() ? Optional.empty() : Optional.of(new HttpExecute(name() + "Execute", calls, within));
        Duration pause = ready;
        if (pause != null) {
            execute.ifPresent(sender -> sender.readyAfter(pause, converter.clock()));
        }
        if (question == null) {
            return new Parts(List.of(), execute.stream().toList(), execute.orElse(null), () -> {}, () -> {});
        }
        HttpPoll poll = new HttpPoll(name(), converter, question, every, within).downAfter(downAfter);
        rules.forEach(rule -> rule.accept(poll));
        Meanings meanings = states;
        execute.ifPresent(sender -> {
            poll.beside(sender);
            if (meanings != null) {
                sender.asking(question, meanings);
            }
        });
        return new Parts(List.of(poll), execute.stream().toList(), poll, poll::open, poll::close);
    }
}
