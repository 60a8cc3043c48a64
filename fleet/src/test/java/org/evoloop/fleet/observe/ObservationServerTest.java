package org.evoloop.fleet.observe;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.micrometer.core.instrument.Gauge;
import io.micrometer.core.instrument.binder.MeterBinder;
import java.net.ServerSocket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;

class ObservationServerTest {
    private final AtomicBoolean good = new AtomicBoolean(true);
    private final MeterBinder metrics = registry ->
            Gauge.builder("evoloop.test", good, state -> state.get() ? 1 : 0).register(registry);

    private ObservationServer open(String address) {
        return ObservationServer.open(
                address, metrics, () -> new Health(good.get(), good.get() ? "fine" : "no broker"));
    }

    private static HttpResponse<String> ask(ObservationServer server, String method, String path) throws Exception {
        HttpRequest request = HttpRequest.newBuilder(URI.create(server.url() + path))
                .method(method, BodyPublishers.noBody())
                .build();
        return HttpClient.newHttpClient().send(request, BodyHandlers.ofString());
    }

    @Test
    void metricsAndHealthAreServed() throws Exception {
        try (ObservationServer server = open("0")) {
            HttpResponse<String> scraped = ask(server, "GET", "/metrics");
            assertThat(scraped.body()).contains("evoloop_test 1", "jvm_memory_used_bytes", "process_cpu_usage");
            assertThat(scraped.headers().firstValue("Content-Type"))
                    .contains("text/plain; version=0.0.4; charset=utf-8");
            HttpResponse<String> health = ask(server, "GET", "/health");
            assertThat(health.statusCode()).isEqualTo(200);
            assertThat(health.body()).isEqualTo("fine\n");
            good.set(false);
            HttpResponse<String> ill = ask(server, "GET", "/health");
            assertThat(ill.statusCode()).isEqualTo(503);
            assertThat(ill.body()).isEqualTo("no broker\n");
            assertThat(ask(server, "HEAD", "/health").statusCode()).isEqualTo(503);
            assertThat(ask(server, "GET", "/").statusCode()).isEqualTo(404);
            assertThat(ask(server, "POST", "/metrics").statusCode()).isEqualTo(405);
        }
    }

    @Test
    void anAddressThatCannotBeUsedIsRefused() throws Exception {
        for (String wrong : new String[] {"x", "70000", "a b:1", ""}) {
            assertThatThrownBy(() -> open(wrong))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("not '" + wrong + "'");
        }
        assertThatThrownBy(() -> open("no-such-host.invalid:1"))
                .hasMessageContaining("no-such-host.invalid:1 cannot be used");
        try (ServerSocket taken = new ServerSocket(0)) {
            assertThatThrownBy(() -> open(String.valueOf(taken.getLocalPort())))
                    .hasMessageContaining("choose another port");
        }
    }
}
