document.querySelectorAll('.wrenches').forEach((box, i) => offer(box, 'wrench', data.series[i].header, () => data.series[i].rows));
